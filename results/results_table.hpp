#pragma once
/// A results file as read back: the rows of its CSV, and what its manifest says of them.

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace trivium {

/// A results file, its manifest or the schema cannot be understood.
class ResultsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
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

/// Runs a program that reads results: what its input did wrong becomes exit code 2, its message on stderr.
int run_on_results(const std::function<int()>& program);

/// Where a CSV's manifest lies.
std::filesystem::path manifest_of(std::filesystem::path csv);

}  // namespace trivium
