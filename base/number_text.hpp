#pragma once
/// Numbers as text with all digits of their scalar type, from float to 100 decimal digits. Also counts with
/// their noun, such as "2 bodies".

#include <fmt/format.h>

#include <concepts>
#include <ios>
#include <limits>
#include <string>
#include <string_view>

namespace trivium {

/// `x` with enough digits to be read back unchanged. Finite numbers are valid JSON.
inline std::string number_text(float x) { return fmt::format("{}", x); }
/// The same for double.
inline std::string number_text(double x) { return fmt::format("{}", x); }
/// The same for long double.
inline std::string number_text(long double x) { return fmt::format("{:.21g}", x); }  // max_digits10 is 21
/// The same for a number of Boost.Multiprecision.
template <class Number>
requires requires(const Number& x) {
  { x.str(1, std::ios_base::fmtflags(0)) } -> std::convertible_to<std::string>;
}
std::string number_text(const Number& x) {
  return x.str(std::numeric_limits<Number>::max_digits10, std::ios_base::fmtflags(0));
}

/// The count with its noun: "1 body", "2 bodies".
inline std::string counted(std::size_t n, std::string_view one, std::string_view more) {
  return fmt::format("{} {}", n, n == 1 ? one : more);
}

}  // namespace trivium
