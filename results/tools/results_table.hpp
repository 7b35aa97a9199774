#pragma once
/// A results file as read back: the rows of its CSV, and what its manifest says of them. A file that was
/// changed since a program wrote it is known by its checksum.

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace trivium {

/// A results file, its manifest or the schema cannot be understood.
class ResultsError : public Error {
 public:
  explicit ResultsError(const std::string& what) : Error(ErrorKind::input, what) {}
};

struct Manifest {
  std::string results, command, commit, csv_sha1;
};

struct ResultsTable {
  std::string name;  ///< of the file, without extension
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  Manifest manifest;
  std::string csv_sha1;  ///< of the CSV as it is now

  bool intact() const { return csv_sha1 == manifest.csv_sha1; }
  /// Throws a ResultsError where there is no such column.
  std::size_t column(const std::string& name) const;
  const std::string& text(std::size_t row, const std::string& column_name) const {
    return rows[row][column(column_name)];
  }
  /// A finite number; a ResultsError where the cell is not one.
  double number(std::size_t row, const std::string& column_name) const;
};

/// The whole of `text` as a finite number, or NaN.
double to_number(const std::string& text);

/// FILE (CSV, RFC 4180) and the manifest beside it. Throws ResultsError and
/// std::filesystem::filesystem_error.
ResultsTable read_results(const std::filesystem::path& csv);

/// Where a CSV's manifest lies.
std::filesystem::path manifest_of(std::filesystem::path csv);

}  // namespace trivium
