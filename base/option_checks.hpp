#pragma once
/// Checks of the values of command line options. An error message states the value found and the values
/// accepted, so that the user can correct the option.

#include <cstdint>
#include <functional>
#include <string>

namespace trivium {

/// The check of an option's value.
struct OptionCheck {
  std::function<std::string(const std::string&)> error_of;  ///< message on a typed value; empty: accepted
  std::string name;                                         ///< kind of value shown in the help text
};

/// Accepts a finite number.
OptionCheck finite_time();

/// Accepts a whole number from 0 to `most`. CLI11 alone would convert "-1" to a huge unsigned number.
OptionCheck whole_number(std::uint64_t most);

/// Accepts a finite number above 0.
OptionCheck positive_number();

/// Accepts a finite number from `least` to `most`.
OptionCheck number_between(double least, double most);

/// Accepts a finite number from 0 on.
OptionCheck number_from_zero();

/// Accepts the path of a regular file or of a file that does not exist yet, in an existing folder.
OptionCheck writable_file();

/// The reason why `path` cannot be a file to write; empty if none is found. Permissions are not checked.
std::string why_not_writable(const std::string& path);

}  // namespace trivium
