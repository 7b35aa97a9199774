#pragma once
/// Comma-separated values (RFC 4180): writes fields as a line and parses text into records of fields. The
/// files of motions and of results use it.

#include <string>
#include <vector>

namespace trivium {

/// One line with its '\n'. A field with a comma, a quote or a line end is quoted.
std::string csv_line(const std::vector<std::string>& fields);

/// All records of `text`. Quoted fields may contain commas, doubled quotes and line ends. Throws an Error
/// (input) if the last line has no '\n' or an open quote: the file was cut off.
std::vector<std::vector<std::string>> parse_csv(const std::string& text);

}  // namespace trivium
