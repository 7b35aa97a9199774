/// Maximum and minimum, and the way NaN stays in them.

#include "base/raise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace trivium {
namespace {

double largest_of(std::initializer_list<double> numbers) {
  double largest = 0;
  for (const double x : numbers) raise(largest, x);
  return largest;
}
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Raise, KeepsTheLargest) {
  EXPECT_EQ(largest_of({1, 3, 2}), 3);
  EXPECT_EQ(largest_of({-1}), 0);
  EXPECT_EQ(largest_of({1, std::numeric_limits<double>::infinity(), 2}),
            std::numeric_limits<double>::infinity());
}

TEST(Raise, KeepsWhatIsNoNumberWhereverItStands) {
  EXPECT_TRUE(std::isnan(largest_of({nan, 1, 2})));
  EXPECT_TRUE(std::isnan(largest_of({1, nan, 2})));
  EXPECT_TRUE(std::isnan(largest_of({1, 2, nan})));
}

TEST(Lower, KeepsTheLeastAndWhatIsNoNumber) {
  const auto least_of = [](std::initializer_list<double> numbers) {
    double least = 10;
    for (const double x : numbers) lower(least, x);
    return least;
  };
  EXPECT_EQ(least_of({3, 1, 2}), 1);
  EXPECT_EQ(least_of({11}), 10);
  EXPECT_TRUE(std::isnan(least_of({nan, 1})));
  EXPECT_TRUE(std::isnan(least_of({1, nan})));
}

TEST(LargestMagnitude, IsThatOfAllNumbersAndOfOneThatIsNone) {
  struct Numbers : std::vector<double> {
    using std::vector<double>::vector;
    using Scalar = double;
  };
  EXPECT_EQ(largest_magnitude(Numbers{1, -3, 2}), 3);
  EXPECT_EQ(largest_magnitude(Numbers{}), 0);
  EXPECT_TRUE(std::isnan(largest_magnitude(Numbers{nan, 1})));
  EXPECT_TRUE(std::isnan(largest_magnitude(Numbers{1, nan, 2})));
}

}  // namespace
}  // namespace trivium
