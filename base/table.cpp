#include "base/table.hpp"

#include <algorithm>

namespace trivium {

namespace {

/// Number of code points, not bytes, since names may contain any UTF-8: counts all but continuation bytes.
std::size_t width_of(const std::string& s) {
  return static_cast<std::size_t>(
      std::count_if(s.begin(), s.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string Table::text() const {
  std::vector<std::size_t> width(rows_.front().size(), 0);
  for (const auto& row : rows_)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], width_of(row[c]));
  std::string text;
  const auto write_row = [&](const std::vector<std::string>& row) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string padding(width[c] - width_of(row[c]), ' ');
      const bool is_left = c == 0 || (ends_in_prose_ && c + 1 == row.size());
      line += (c == 0 ? "" : "  ") + (is_left ? row[c] + padding : padding + row[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  write_row(rows_.front());
  std::size_t total = 2 * (width.size() - 1);
  for (std::size_t w : width) total += w;
  text += std::string(total, '-') + "\n";
  for (std::size_t r = 1; r < rows_.size(); ++r) write_row(rows_[r]);
  return text;
}

}  // namespace trivium
