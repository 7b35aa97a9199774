#include "base/json_writer.hpp"

#include <fmt/format.h>

namespace trivium {

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
