/// CSV text is read back unchanged. Text that was cut off is an error.

#include "base/csv.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace trivium {
namespace {

TEST(Csv, FieldsAreReadBackAsWritten) {
  const std::vector<std::vector<std::string>> records{{"name", "value"},     {"a, b", "1"},
                                                      {"say \"no\"", ""},    {"two\nlines", "\""},
                                                      {"", "after nothing"}, {"a\r", ""}};
  std::string text;
  for (const auto& record : records) text += csv_line(record);
  EXPECT_EQ(parse_csv(text), records);
}

TEST(Csv, OnlyFieldsThatNeedQuotesHaveThem) {
  EXPECT_EQ(csv_line({"plain", "1e-16", "a,b", "\""}), "plain,1e-16,\"a,b\",\"\"\"\"\n");
}

TEST(Csv, ATextWithoutRecordsHasNone) { EXPECT_TRUE(parse_csv("").empty()); }

TEST(Csv, ALastLineThatDoesNotEndIsAnError) {
  for (const char* text : {"a,b", "a\nb", "a,\"b\n", "a,"}) EXPECT_THROW(parse_csv(text), Error) << text;
}

}  // namespace
}  // namespace trivium
