/// Accepted and rejected values of options, at the limits of each range.

#include "base/option_checks.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace trivium {
namespace {

void expect(const OptionCheck& check, const std::vector<std::string>& accepted,
            const std::vector<std::string>& refused) {
  for (const std::string& text : accepted) EXPECT_EQ(check.error_of(text), "") << text;
  for (const std::string& text : refused) EXPECT_NE(check.error_of(text), "") << text;
}

TEST(OptionChecks, ATimeIsAFiniteNumber) {
  expect(finite_time(), {"0", "-1.5", "1e-3"}, {"", "nan", "inf", "1e400", "1x", "x"});
}

TEST(OptionChecks, AWholeNumberDoesNotWrapAround) {
  expect(whole_number(10), {"0", "10"}, {"", "-1", "11", "1.5", "18446744073709551616"});
  EXPECT_EQ(whole_number(10).error_of("-1"), "found -1; accepted: a whole number from 0 to 10");
}

TEST(OptionChecks, ZeroIsNotPositive) {
  expect(positive_number(), {"1e-9", "3"}, {"0", "-1", "nan", "inf", ""});
  expect(number_between(0.5, 2), {"0.5", "1", "2"}, {"0.4", "2.1", "nan", "inf", ""});
  expect(number_from_zero(), {"0", "3"}, {"-1e-9", "nan", "inf", ""});
}

}  // namespace
}  // namespace trivium
