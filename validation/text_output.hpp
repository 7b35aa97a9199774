#pragma once
/// Text that people and programs read: numbers with all digits of their Scalar, aligned tables, JSON.

#include <fmt/format.h>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "bodies/scalar.hpp"

namespace trivium {

/// A number with as many digits as it takes to read it back unchanged; valid JSON.
inline std::string number_text(float x) { return fmt::format("{}", x); }
inline std::string number_text(double x) { return fmt::format("{}", x); }
inline std::string number_text(long double x) { return fmt::format("{:.21g}", x); }
template <class Number>
requires boost::multiprecision::is_number<Number>::value std::string number_text(const Number& x) {
  return x.str(std::numeric_limits<Number>::max_digits10, std::ios_base::fmtflags(0));
}

/// "1 body", "2 bodies".
inline std::string counted(std::size_t n, std::string_view one, std::string_view more) {
  return fmt::format("{} {}", n, n == 1 ? one : more);
}

/// A line of CSV, fields quoted where they need it (RFC 4180).
std::string csv_line(const std::vector<std::string>& fields);

/// A table of text: the first column left-aligned, the others right-aligned.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// Lines ending in '\n', a rule under the header.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// Writes one JSON value: objects and arrays of objects over lines, arrays of numbers on one.
class JsonWriter {
 public:
  JsonWriter& begin_object(std::string_view key = {}) { return open(key, '{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array(std::string_view key = {}) { return open(key, '['); }
  JsonWriter& end_array() { return close(']'); }

  JsonWriter& text(std::string_view key, std::string_view value) { return raw(key, quote(value)); }
  JsonWriter& flag(std::string_view key, bool value) { return raw(key, value ? "true" : "false"); }
  template <class Number>
  JsonWriter& number(std::string_view key, const Number& value) {
    return raw(key, json_number(value));
  }
  template <class Vector>
  JsonWriter& numbers(std::string_view key, const Vector& values) {
    std::string list;
    for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(values.size()); ++k)
      list += (k ? ", " : "") + json_number(values[k]);
    return raw(key, "[" + list + "]");
  }
  JsonWriter& texts(std::string_view key, const std::vector<std::string>& values);
  JsonWriter& flags(std::string_view key, const std::vector<bool>& values);

  /// The finished value and a newline.
  std::string str() const { return out_ + "\n"; }

 private:
  static std::string quote(std::string_view s);
  template <class Number>
  static std::string json_number(const Number& value) {
    if constexpr (std::is_integral_v<Number>)
      return std::to_string(value);
    else
      return isfinite_(value) ? number_text(value) : "null";  // JSON has no infinity
  }
  template <class Number>
  static bool isfinite_(const Number& x) {
    using std::isfinite;
    return isfinite(x);
  }
  JsonWriter& raw(std::string_view key, std::string_view value);
  JsonWriter& open(std::string_view key, char bracket);
  JsonWriter& close(char bracket);
  void begin_value(std::string_view key);

  std::string out_;
  int depth_ = 0;
  bool first_ = true;
};

}  // namespace trivium
