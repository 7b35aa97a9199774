#pragma once
/// Whether an error message announces a failure: it says what failed, where, when, why, and what to try.

#include <optional>
#include <string>

namespace trivium::hard {

/// What a message lacks of a place (a name in quotes), a time and advice; empty if nothing.
std::string missing_in_announcement(const std::string& message, std::optional<double> when);

}  // namespace trivium::hard
