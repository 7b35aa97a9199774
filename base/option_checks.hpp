#pragma once
/// What the values of options must be; each check says what it found and what is accepted.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "base/whole_file.hpp"

namespace trivium {

/// Accepts a finite number.
inline CLI::Validator finite_time() {
  return {[](std::string& text) {
            double t = 0;
            return CLI::detail::lexical_cast(text, t) && std::isfinite(t) ? std::string()
                                                                          : "not a finite number: " + text;
          },
          "FINITE"};
}

/// Accepts a whole number from 0 to `most`, which CLI11 alone would let wrap around below zero.
inline CLI::Validator whole_number(std::uint64_t most) {
  return {[most](std::string& text) {
            std::uint64_t value = 0;
            const char* end = text.data() + text.size();
            const auto [read, error] = std::from_chars(text.data(), end, value);
            return error == std::errc() && read == end && value <= most
                       ? std::string()
                       : fmt::format("found {}; accepted: a whole number from 0 to {}", text, most);
          },
          "WHOLE"};
}

/// What keeps a file from being written there; empty if nothing does.
inline std::string why_not_writable(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr const char* accepted = "accepted: a file in a folder that exists";
  if (path.empty()) return fmt::format("\"\" is not a file; {}", accepted);
  const std::optional<fs::path> target = file_to_write(path);
  if (!target) return fmt::format("\"{}\" is there and not a regular file; {}", path, accepted);
  std::error_code error;
  const fs::path folder = target->parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    return fmt::format("{}: the folder {} does not exist; {}", path, folder.string(), accepted);
  if (!target->has_filename()) return fmt::format("\"{}\" is not a file; {}", path, accepted);
  return {};
}

/// Accepts a path that a file can be written to: a regular file or none yet, in a folder that exists.
inline CLI::Validator writable_file() {
  return {[](std::string& text) { return why_not_writable(text); }, "FILE"};
}

}  // namespace trivium
