/// The written JSON is valid for any values, and numbers keep all their digits.

#include "base/json_writer.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace trivium {
namespace {

TEST(JsonWriter, PutsObjectsOnLinesAndNumbersOnOne) {
  JsonWriter json;
  json.begin_object()
      .text("name", "top")
      .number("nb", 3)
      .flag("passed", true)
      .numbers("x", std::vector<double>{1, -0.5})
      .texts("rows", {"a", "b"})
      .flags("unique", {true, false})
      .begin_array("parts")
      .begin_object()
      .number("t", 0.1)
      .end_object()
      .end_array()
      .end_object();
  EXPECT_EQ(json.str(), R"({
  "name": "top",
  "nb": 3,
  "passed": true,
  "x": [1, -0.5],
  "rows": ["a", "b"],
  "unique": [true, false],
  "parts": [
    {
      "t": 0.1
    }
  ]
}
)");
}

TEST(JsonWriter, AnEmptyValueStaysOnItsLine) {
  JsonWriter json;
  json.begin_object().begin_array("differences").end_array().texts("rows", {}).end_object();
  EXPECT_EQ(json.str(), "{\n  \"differences\": [],\n  \"rows\": []\n}\n");
}

TEST(JsonWriter, EscapesWhatJsonDoesNotAllowInAString) {
  JsonWriter json;
  json.begin_object().text("a\"b", "\\ \n \x01").end_object();
  EXPECT_EQ(json.str(), "{\n  \"a\\\"b\": \"\\\\ \\u000a \\u0001\"\n}\n");
}

TEST(JsonWriter, ANumberThatIsNotFiniteIsNull) {
  JsonWriter json;
  const double infinity = std::numeric_limits<double>::infinity();
  json.begin_object()
      .numbers("x", std::vector<double>{infinity, -infinity, infinity - infinity})
      .end_object();
  EXPECT_EQ(json.str(), "{\n  \"x\": [null, null, null]\n}\n");
}

TEST(NumberText, HasTheDigitsThatReadBackTheSameNumber) {
  for (const double x : {0.1, 1.0 / 3, 1e-300, 123456789.123456789}) EXPECT_EQ(std::stod(number_text(x)), x);
  EXPECT_EQ(std::stof(number_text(0.1F)), 0.1F);
  EXPECT_EQ(std::stold(number_text(0.1L)), 0.1L);
}

TEST(NumberText, CountsInWords) {
  EXPECT_EQ(counted(1, "body", "bodies"), "1 body");
  EXPECT_EQ(counted(0, "body", "bodies"), "0 bodies");
}

}  // namespace
}  // namespace trivium
