#pragma once
/// Writes the results of a validation program: a CSV file, and a manifest that names the sources, the
/// compiler and the command. Both are read back by results_table.hpp.

#include <filesystem>
#include <string>
#include <vector>

namespace trivium {

/// A number with seven significant digits. More digits of a rounding error would carry no information.
std::string results_number(double x);

/// The answer of a validation program to its question, as a table of texts.
class ResultsFile {
 public:
  ResultsFile(std::string name, std::vector<std::string> columns);

  void add(std::vector<std::string> row);

  /// Writes the CSV, and a manifest with extension .manifest.json: commit, compiler, flags, versions, CPU,
  /// command line and the checksum of the CSV. Each file appears completely or not at all.
  void write(const std::filesystem::path& file, int argc, const char* const* argv) const;

 private:
  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace trivium
