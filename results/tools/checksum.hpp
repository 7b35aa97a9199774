#pragma once
/// The checksum that shows whether a results file is still as its program wrote it. It protects against
/// accidental changes, not against an attacker.

#include <string>
#include <string_view>

namespace trivium {

/// The SHA-1 of the bytes as 40 hexadecimal digits, as `sha1sum` prints it.
std::string sha1_of(std::string_view bytes);

}  // namespace trivium
