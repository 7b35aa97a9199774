#include "validation/text_output.hpp"

#include <algorithm>

namespace trivium {

namespace {

std::string csv_field(const std::string& s) {
  if (s.find_first_of(",\"\n") == std::string::npos) return s;
  std::string out = "\"";
  for (char c : s) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += (line.empty() ? "" : ",") + csv_field(field);
  return line + "\n";
}

namespace {

/// Characters, not bytes: names may hold any UTF-8.
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
      line += c == 0 ? row[c] + padding : "  " + padding + row[c];
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

JsonWriter& JsonWriter::texts(std::string_view key, const std::vector<std::string>& values) {
  std::string list;
  for (const std::string& value : values) list += (list.empty() ? "" : ", ") + quote(value);
  return raw(key, "[" + list + "]");
}

JsonWriter& JsonWriter::flags(std::string_view key, const std::vector<bool>& values) {
  std::string list;
  for (bool value : values) list += std::string(list.empty() ? "" : ", ") + (value ? "true" : "false");
  return raw(key, "[" + list + "]");
}

std::string JsonWriter::quote(std::string_view s) {
  std::string out = "\"";
  for (char c : s) {
    if (c == '"' || c == '\\')
      out += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      out += c;
  }
  return out + "\"";
}

void JsonWriter::begin_value(std::string_view key) {
  if (depth_ > 0) {
    if (!first_) out_ += ",";
    out_ += "\n" + std::string(2 * static_cast<std::size_t>(depth_), ' ');
  }
  if (!key.empty()) out_ += quote(key) + ": ";
  first_ = false;
}

JsonWriter& JsonWriter::raw(std::string_view key, std::string_view value) {
  begin_value(key);
  out_ += value;
  return *this;
}

JsonWriter& JsonWriter::open(std::string_view key, char bracket) {
  begin_value(key);
  out_ += bracket;
  ++depth_;
  first_ = true;
  return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
  --depth_;
  if (!first_) out_ += "\n" + std::string(2 * static_cast<std::size_t>(depth_), ' ');
  out_ += bracket;
  first_ = false;
  return *this;
}

}  // namespace trivium
