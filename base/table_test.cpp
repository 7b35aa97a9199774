/// Columns are aligned by characters, also for names with non-ASCII letters.

#include "base/table.hpp"

#include <gtest/gtest.h>

namespace trivium {
namespace {

TEST(Table, AlignsTheFirstColumnLeftAndTheOthersRight) {
  Table table({"row", "value"});
  table.add({"left.d", "1"});
  table.add({"x", "-0.25"});
  EXPECT_EQ(table.text(),
            "row     value\n"
            "-------------\n"
            "left.d      1\n"
            "x       -0.25\n");
}

TEST(Table, MeasuresCharactersAndNotBytes) {
  Table table({"name", "n"});
  table.add({"Käfer", "1"});
  table.add({"beetle", "2"});
  EXPECT_EQ(table.text(),
            "name    n\n"
            "---------\n"
            "Käfer   1\n"
            "beetle  2\n");
}

TEST(Table, HasNoBlanksAtTheEndOfALine) {
  Table table({"row", "", ""});
  table.add({"a", "", ""});
  EXPECT_EQ(table.text(), "row\n-------\na\n");
}

}  // namespace
}  // namespace trivium
