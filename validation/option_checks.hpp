#pragma once
/// What the values of options must be; each check says what it found and what is accepted.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

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

/// Accepts a path that a file can be written to: no folder itself, and in a folder that exists.
inline CLI::Validator writable_file() {
  return {[](std::string& text) {
            namespace fs = std::filesystem;
            constexpr const char* accepted = "accepted: a file in a folder that exists";
            std::error_code error;
            const fs::path folder = fs::path(text).parent_path();
            if (!folder.empty() && !fs::is_directory(folder, error))
              return fmt::format("{}: the folder {} does not exist; {}", text, folder.string(), accepted);
            if (text.empty() || fs::is_directory(text, error))
              return fmt::format("\"{}\" is not a file; {}", text, accepted);
            return std::string();
          },
          "FILE"};
}

}  // namespace trivium
