#pragma once
/// The checksum by which an accepted file is known to be what a program wrote. It guards against slips of the
/// hand, not against an attacker.

#include <string>
#include <string_view>

namespace trivium {

/// SHA-1, 40 hexadecimal digits as `sha1sum` prints them: against slips of the hand, not against an attacker.
std::string sha1_of(std::string_view bytes);

}  // namespace trivium
