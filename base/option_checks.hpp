#pragma once
/// Decides which values an option accepts. Each check says what was found and what is accepted, so that the
/// message of a program can be acted on.

#include <cstdint>
#include <functional>
#include <string>

namespace trivium {

struct OptionCheck {
  std::function<std::string(const std::string&)> error_of;  ///< of a value as typed; empty: accepted
  std::string name;                                         ///< behind the type in the help text
};

/// Accepts a finite number.
OptionCheck finite_time();

/// Accepts a whole number from 0 to `most`, which CLI11 alone would let wrap around below zero.
OptionCheck whole_number(std::uint64_t most);

/// Accepts a finite number above 0.
OptionCheck positive_number();

/// Accepts a finite number from 0 on.
OptionCheck number_from_zero();

/// Accepts a path that a file can be written to: a regular file or none yet, in a folder that exists.
OptionCheck writable_file();

/// What keeps a file from being written there; empty if nothing does.
std::string why_not_writable(const std::string& path);

}  // namespace trivium
