/// Reads each results file once, checks it against its schema, and makes all tables of the paper.

#include "paper/generator/table.hpp"

#include <fmt/format.h>

#include "results/tools/results_comparison.hpp"

namespace trivium::paper {

const ResultsTable& Results::operator[](const std::string& name) {
  if (const auto known = read_.find(name); known != read_.end()) return known->second;
  const auto schema = read_schema(directory_ / "schema.json");
  ResultsTable table = read_results(directory_ / (name + ".csv"));
  for (const Difference& d : check_results(find_schema(schema, name), table))
    throw ResultsError(fmt::format("{}: {}{}{} is {} (rule: {})", name, d.row, d.row.empty() ? "" : ", ",
                                   d.column, d.accepted, d.rule));
  return read_.emplace(name, std::move(table)).first->second;
}

std::map<std::string, std::string> render(const std::filesystem::path& directory) {
  Results results(directory);
  Numbers numbers;
  std::map<std::string, std::string> files;
  for (const PaperTable& table : paper_tables)
    files.emplace(std::string(table.name) + ".tex", table.make(results, numbers));
  files.emplace("numbers.tex", numbers.str());
  return files;
}

}  // namespace trivium::paper
