#pragma once
/// Comma-separated values (RFC 4180): a line of fields as text, and text as rows of fields. Motions and
/// results files are written and read by it.

#include <string>
#include <vector>

namespace trivium {

/// A line of CSV, fields quoted where they need it (RFC 4180).
std::string csv_line(const std::vector<std::string>& fields);

/// The records of a text; quoted fields may hold commas, doubled quotes and line ends. Throws an Error where
/// the last line does not end.
std::vector<std::vector<std::string>> parse_csv(const std::string& text);

}  // namespace trivium
