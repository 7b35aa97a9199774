#pragma once
/// Writes a report as JSON, value by value: the output of --json and the manifests of results. Scene files
/// have another writer, scenes/format/json_printer.cpp, which keeps the layout of hand-written files.

#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/number_text.hpp"

namespace trivium {

/// Writes one JSON value. Objects and arrays of objects get one line per element; arrays of numbers, texts or
/// flags stay on one line. Members of an object need a key; elements of an array have none.
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
    for (const auto& value : values) list += (list.empty() ? "" : ", ") + json_number(value);
    return raw(key, "[" + list + "]");
  }
  JsonWriter& texts(std::string_view key, const std::vector<std::string>& values);
  JsonWriter& flags(std::string_view key, const std::vector<bool>& values);

  /// The JSON text with a final newline.
  std::string str() const { return out_ + "\n"; }

 private:
  static std::string quote(std::string_view s);
  template <class Number>
  static std::string json_number(const Number& value) {
    if constexpr (std::is_integral_v<Number>)
      return std::to_string(value);
    else
      return isfinite_(value) ? number_text(value) : "null";  // JSON has neither infinity nor NaN
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
