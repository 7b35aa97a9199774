/// The columns of the file are matched by name first, then every line is read. Spaces, plus signs and line
/// ends of other systems are accepted.

#include "simulation/other_motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/csv.hpp"
#include "base/error.hpp"
#include "base/whole_file.hpp"

namespace trivium {

namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& found, const std::string& accepted) {
  throw Error(ErrorKind::input, Place{where}, fmt::format("{}; accepted: {}", found, accepted));
}

std::string first_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 8;  // enough to show what names look like; a scene can have hundreds
  const std::vector<std::string> shown(names.begin(),
                                       names.begin() + static_cast<long>(std::min(most, names.size())));
  return fmt::format("{}{}", fmt::join(shown, ", "), names.size() > most ? ", ..." : "");
}

double number_in(const std::string& text, const std::string& where) {
  const auto from = std::find_if(text.begin(), text.end(), [](char c) { return c != ' ' && c != '+'; });
  const auto to =
      std::find_if(text.rbegin(), text.rend(), [](char c) { return c != ' ' && c != '\r'; }).base();
  double x = 0;
  if (from < to) {
    const char* const end = &*from + (to - from);
    const auto [last, error] = std::from_chars(&*from, end, x);
    if (error == std::errc() && last == end && std::isfinite(x)) return x;
  }
  refuse(where, fmt::format("found \"{}\"", text), "a finite number");
}

}  // namespace

OtherMotion read_motion(const std::string& file, const std::map<std::string, std::string>& names,
                        const std::vector<std::string>& ours) {
  namespace fs = std::filesystem;
  if (std::error_code error; !fs::is_regular_file(file, error))
    refuse(file, fs::is_directory(file, error) ? "a folder" : "no such file", "a CSV file");
  std::vector<std::vector<std::string>> lines;
  try {
    std::string text = read_whole(file);
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // the byte order mark of UTF-8
    if (!text.empty() && text.back() != '\n') text += '\n';
    lines = parse_csv(text);
  } catch (const Error& error) {
    throw Error(file, error);
  }
  if (lines.size() < 3)
    refuse(file, fmt::format("{} lines", lines.size()),
           "a line of column names and at least two lines of numbers");

  OtherMotion motion;
  std::optional<std::size_t> time;
  std::vector<std::size_t> place;  // per recognised column: its index in the file
  for (std::string& name : lines[0]) {
    while (!name.empty() && (name.back() == '\r' || name.back() == ' ')) name.pop_back();
    name.erase(0, name.find_first_not_of(' '));
  }
  for (std::size_t k = 0; k < lines[0].size(); ++k) {
    const std::string& theirs = lines[0][k];
    const auto named = names.find(theirs);
    const std::string& name = named == names.end() ? theirs : named->second;
    if (name == "t") {
      time = k;
    } else if (std::find(ours.begin(), ours.end(), name) == ours.end()) {
      motion.unknown.push_back(theirs);
    } else {
      const auto twice = [&](const OtherMotion::Column& column) { return column.ours == name; };
      if (std::any_of(motion.columns.begin(), motion.columns.end(), twice))
        refuse(file, fmt::format("two columns are \"{}\"", name), "one");
      motion.columns.push_back({theirs, name, {}});
      place.push_back(k);
    }
  }
  for (const auto& [theirs, name] : names) {
    if (std::find(ours.begin(), ours.end(), name) == ours.end())
      refuse(fmt::format("--map {}={}", theirs, name), fmt::format("no column \"{}\"", name), first_of(ours));
    if (std::find(lines[0].begin(), lines[0].end(), theirs) == lines[0].end())
      refuse(fmt::format("--map {}={}", theirs, name), fmt::format("{} has no column \"{}\"", file, theirs),
             first_of(lines[0]));
  }
  if (!time)
    refuse(file, fmt::format("no time column among {}", first_of(lines[0])), "one named t, or --map NAME=t");
  if (motion.columns.empty())
    refuse(file, fmt::format("no known column name among {}", first_of(lines[0])),
           fmt::format("names such as {}, or --map THEIRS=OURS", first_of(ours)));

  for (std::size_t n = 1; n < lines.size(); ++n) {
    const auto where = [&](std::size_t k) {
      return fmt::format("{}: line {}, {}", file, n + 1, lines[0][k]);
    };
    if (lines[n].size() != lines[0].size())
      refuse(fmt::format("{}: line {}", file, n + 1), fmt::format("{} fields", lines[n].size()),
             fmt::format("{}, as in the first line", lines[0].size()));
    const double t = number_in(lines[n][*time], where(*time));
    if (!motion.t.empty() && !(t > motion.t.back()))
      refuse(where(*time), fmt::format("found t = {} after t = {}", t, motion.t.back()), "ascending times");
    motion.t.push_back(t);
    for (std::size_t c = 0; c < place.size(); ++c)
      motion.columns[c].value.push_back(number_in(lines[n][place[c]], where(place[c])));
  }
  return motion;
}

}  // namespace trivium
