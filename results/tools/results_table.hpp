#pragma once
/// A results file as it is read: the rows of its CSV and its manifest. The checksum in the manifest shows
/// whether the CSV was changed after a program wrote it.

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace trivium {

/// The error for a results file, manifest or schema that cannot be understood.
class ResultsError : public Error {
 public:
  explicit ResultsError(const std::string& what) : Error(ErrorKind::input, what) {}
};

struct Manifest {
  std::string results, command, commit, csv_sha1;
};

struct ResultsTable {
  std::string name;  ///< name of the file without extension
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  Manifest manifest;
  std::string csv_sha1;  ///< checksum of the CSV as it is now

  bool intact() const { return csv_sha1 == manifest.csv_sha1; }
  /// The index of a column. Throws a ResultsError if there is no such column.
  std::size_t column(const std::string& name) const;
  const std::string& text(std::size_t row, const std::string& column_name) const {
    return rows[row][column(column_name)];
  }
  /// The finite number in a cell. Throws a ResultsError if the cell holds something else.
  double number(std::size_t row, const std::string& column_name) const;
};

/// The number that the whole of `text` states, or NaN if it is not a finite number.
double to_number(const std::string& text);

/// Reads a CSV file (RFC 4180) and its manifest from the same folder. Throws ResultsError and
/// std::filesystem::filesystem_error.
ResultsTable read_results(const std::filesystem::path& csv);

/// The path of the manifest of a CSV file.
std::filesystem::path manifest_of(std::filesystem::path csv);

}  // namespace trivium
