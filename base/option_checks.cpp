#include "base/option_checks.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "base/whole_file.hpp"

namespace trivium {

namespace {

/// The value of `text` if all of it is a finite number, otherwise none. Uses strtold as CLI11 does, so that
/// the check and the later conversion accept the same texts.
std::optional<double> finite_number(const std::string& text) {
  char* end = nullptr;
  const auto x = static_cast<double>(std::strtold(text.c_str(), &end));
  const bool whole = !text.empty() && end == text.c_str() + text.size();
  return whole && std::isfinite(x) ? std::optional(x) : std::nullopt;
}

/// Accepts the finite numbers for which `holds`; `accepted` names them for the message.
template <class Holds>
OptionCheck number(Holds holds, std::string accepted, std::string name) {
  return {[holds, accepted = std::move(accepted)](const std::string& text) {
            const std::optional<double> x = finite_number(text);
            return x && holds(*x) ? std::string() : fmt::format("found {}; accepted: {}", text, accepted);
          },
          std::move(name)};
}

}  // namespace

OptionCheck finite_time() {
  return {[](const std::string& text) {
            return finite_number(text) ? std::string() : "not a finite number: " + text;
          },
          "FINITE"};
}

OptionCheck whole_number(std::uint64_t most) {
  return {[most](const std::string& text) {
            std::uint64_t value = 0;
            const char* end = text.data() + text.size();
            const auto [read, error] = std::from_chars(text.data(), end, value);
            return error == std::errc() && read == end && value <= most
                       ? std::string()
                       : fmt::format("found {}; accepted: a whole number from 0 to {}", text, most);
          },
          "WHOLE"};
}

OptionCheck positive_number() {
  return number([](double x) { return x > 0; }, "a number above 0", "POSITIVE");
}

OptionCheck number_between(double least, double most) {
  return number([least, most](double x) { return x >= least && x <= most; },
                fmt::format("a number from {} to {}", least, most), "NUMBER");
}

OptionCheck number_from_zero() {
  return number([](double x) { return x >= 0; }, "a number not below 0", "NUMBER");
}

OptionCheck writable_file() { return {why_not_writable, "FILE"}; }

std::string why_not_writable(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr const char* accepted = "accepted: a file in a folder that exists";
  if (path.empty()) return fmt::format("\"\" is not a file; {}", accepted);
  const std::optional<fs::path> target = file_to_write(path);
  if (!target) return fmt::format("\"{}\" exists but is not a regular file; {}", path, accepted);
  std::error_code error;
  const fs::path folder = target->parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    return fmt::format("{}: the folder {} does not exist; {}", path, folder.string(), accepted);
  if (!target->has_filename()) return fmt::format("\"{}\" is not a file; {}", path, accepted);
  return {};
}

}  // namespace trivium
