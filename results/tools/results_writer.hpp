#pragma once
/// Writes the results of a validation: a CSV and, beside it, a manifest that says which sources, compiler and
/// command made them. They are read back by results_table.hpp.

#include <filesystem>
#include <string>
#include <vector>

namespace trivium {

/// A number as results keep it: what rounding left of a difference has no more digits worth keeping.
std::string results_number(double x);

/// The question that a validation executable answers, as data: one row an answer.
class ResultsFile {
 public:
  ResultsFile(std::string name, std::vector<std::string> columns);

  void add(std::vector<std::string> row);

  /// Writes FILE (CSV) and FILE with the extension .manifest.json: commit, compiler, flags, versions, CPU,
  /// command line and the CSV's checksum. Both appear whole or not at all.
  void write(const std::filesystem::path& file, int argc, const char* const* argv) const;

 private:
  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace trivium
