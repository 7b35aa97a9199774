#pragma once
/// Files read and written whole.

#include <filesystem>
#include <string>
#include <string_view>

namespace trivium {

/// Throws std::filesystem::filesystem_error.
std::string read_whole(const std::filesystem::path& file);

/// The file has all of the text or stays as it was; see file_to_write for what is a file. Throws
/// std::filesystem::filesystem_error.
void write_whole(const std::filesystem::path& file, std::string_view text);

}  // namespace trivium
