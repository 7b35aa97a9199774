#pragma once
/// Numbers as text, with all digits of their scalar, from float to 100 digits. Counts in words stand here
/// too.

#include <fmt/format.h>

#include <concepts>
#include <ios>
#include <limits>
#include <string>
#include <string_view>

namespace trivium {

/// A number with as many digits as it takes to read it back unchanged; valid JSON.
inline std::string number_text(float x) { return fmt::format("{}", x); }
inline std::string number_text(double x) { return fmt::format("{}", x); }
inline std::string number_text(long double x) { return fmt::format("{:.21g}", x); }
template <class Number>
requires requires(const Number& x) {
  { x.str(1, std::ios_base::fmtflags(0)) } -> std::convertible_to<std::string>;
}
std::string number_text(const Number& x) {
  return x.str(std::numeric_limits<Number>::max_digits10, std::ios_base::fmtflags(0));
}

/// "1 body", "2 bodies".
inline std::string counted(std::size_t n, std::string_view one, std::string_view more) {
  return fmt::format("{} {}", n, n == 1 ? one : more);
}

}  // namespace trivium
