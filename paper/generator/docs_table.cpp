/// docs_table: prints a table of the documentation, as Markdown, from results/. docs/ shows its output, and a
/// test compares the two.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/exit_code.hpp"
#include "base/program_options.hpp"
#include "paper/generator/formulations.hpp"
#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

void print_row(const std::vector<std::string>& cells) {
  fmt::print("|");
  for (const std::string& cell : cells) fmt::print(" {} |", cell);
  fmt::print("\n");
}

/// The heading of a table: its first column, and the others.
void print_head(const std::string& first, const std::vector<std::string>& others) {
  std::vector<std::string> cells{first};
  cells.insert(cells.end(), others.begin(), others.end());
  print_row(cells);
  print_row(std::vector<std::string>(cells.size(), "---"));
}

/// One decimal below 10, none above. 9.95 is the limit at which rounding adds a digit.
std::string rounded(double x) { return x >= 9.95 ? fmt::format("{:.0f}", x) : fmt::format("{:.1f}", x); }

/// CPU time [ms] of a method's cheapest run in r-omega whose error of positions is at most `error` [m], or
/// "-" if no run reaches this error. 0.95 is the limit below which one decimal leaves a single digit; two
/// decimals are shown there.
std::string cheapest(const ResultsTable& table, const std::string& scene, const std::string& method,
                     double error) {
  std::optional<double> least;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (table.text(row, "scene") == scene && table.text(row, "method") == method &&
        table.text(row, "formulation") == "r-omega" && table.text(row, "failure") == "none" &&
        table.number(row, "position") <= error) {
      const double ms = table.number(row, "median_ms");
      least = std::min(least.value_or(ms), ms);
    }
  return !least ? "-" : *least < 0.95 ? fmt::format("{:.2f}", *least) : rounded(*least);
}

/// Prints the CPU time [ms] that each method needs for an error of positions [m], one column for each scene.
void time_by_method(Results& results, double error) {
  const ResultsTable& table = results["work_precision"];
  const std::vector<std::string> scenes = distinct(table, "scene");
  print_head("method", scenes);
  for (const std::string& method : distinct(table, "method")) {
    std::vector<std::string> cells{fmt::format("`{}`", method)};
    for (const std::string& scene : scenes) cells.push_back(cheapest(table, scene, method, error));
    // Simbody's methods have no formulation, so `cheapest` finds no run of theirs; their rows are omitted
    if (std::any_of(cells.begin() + 1, cells.end(), [](const std::string& cell) { return cell != "-"; }))
      print_row(cells);
  }
}

/// Prints the time of a step in every formulation, relative to r-omega: the median over the scenes, with the
/// smallest and largest ratio.
void time_by_formulation(Results& results) {
  const ResultsTable& table = results["formulation_speed"];
  const std::vector<std::string> formulations = distinct(table, "formulation");
  print_head("method", formulations);
  for (const std::string& method : distinct(table, "method")) {
    std::vector<std::string> cells{method};
    for (const std::string& formulation : formulations) {
      Sample ratios;
      for (std::size_t row = 0; row < table.rows.size(); ++row)
        if (table.text(row, "method") == method && table.text(row, "formulation") == formulation)
          ratios.add(table.number(row, "ratio"));
      cells.push_back(
          ratios.least() == ratios.worst()
              ? fmt::format("{:.2f}", ratios.median())
              : fmt::format("{:.2f} ({:.2f} to {:.2f})", ratios.median(), ratios.least(), ratios.worst()));
    }
    print_row(cells);
  }
}

/// Prints the microseconds of one evaluation of accelerations and lambda, one line for each scene. The times
/// of Trivium include the refinement.
void time_by_engine(Results& results) {
  const ResultsTable& table = results["acceleration_cost"];
  const auto column_of = [&](std::size_t row) {
    const std::string& formulation = table.text(row, "formulation");
    return table.text(row, "engine") == "Trivium" ? formulation : table.text(row, "engine");
  };
  std::vector<std::string> columns;
  std::map<std::pair<std::string, std::string>, std::string> cell;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.text(row, "refinement") == "unrefined") continue;
    const std::string column = column_of(row);
    if (std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
    const std::string& time = table.text(row, "microseconds");
    // emplace keeps the first time of a column: for an engine with several formulations, that of r-omega
    cell.emplace(std::pair(table.text(row, "scene"), column),
                 time == "none" ? "-" : rounded(to_number(time)));
  }
  print_head("scene", columns);
  for (const std::string& scene : distinct(table, "scene")) {
    std::vector<std::string> cells{scene};
    for (const std::string& column : columns) {
      const auto found = cell.find({scene, column});
      cells.push_back(found == cell.end() ? "-" : found->second);
    }
    print_row(cells);
  }
}

}  // namespace

}  // namespace trivium::paper

int main(int argc, char** argv) {
  using namespace trivium;
  using Print = void (*)(paper::Results&);
  const std::map<std::string, Print> tables{
      {"time_by_engine", paper::time_by_engine},
      {"time_by_formulation", paper::time_by_formulation},
      {"time_by_method_1e-3", [](paper::Results& results) { paper::time_by_method(results, 1e-3); }},
      {"time_by_method_1e-6", [](paper::Results& results) { paper::time_by_method(results, 1e-6); }},
      {"time_by_method_1e-9", [](paper::Results& results) { paper::time_by_method(results, 1e-9); }}};
  ProgramOptions options("Prints a table of the documentation, as Markdown, from accepted results",
                         "docs_table");
  std::string results, name;
  std::vector<std::string> names;
  for (const auto& [table, print] : tables) names.push_back(table);
  options.add_option("RESULTS", &results, "Folder of the accepted results, with their schema").required();
  options.add_option("TABLE", &name, "Name of the table").required().one_of(names);
  return options.run(argc, argv, [&] {
    paper::Results accepted(results);
    tables.at(name)(accepted);
    return exit_done;
  });
}
