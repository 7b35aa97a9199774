/// Finds the formulations of a results file, and the LaTeX command that prints the name of each.

#include "paper/generator/formulations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace trivium::paper {

std::vector<std::string> distinct(const ResultsTable& table, const std::string& column) {
  std::vector<std::string> found;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (const std::string& one = table.text(row, column);
        std::find(found.begin(), found.end(), one) == found.end())
      found.push_back(one);
  return found;
}

std::vector<std::string> formulations_of(const ResultsTable& table, std::size_t rows_each) {
  std::vector<std::string> found = distinct(table, "formulation");
  if (found.empty() || table.rows.size() % (rows_each * found.size()) != 0)
    throw ResultsError(table.name + ": a row of some formulation is missing");
  return found;
}

Tex heading(const std::string& formulation) {
  static const std::map<std::string, Tex> commands{{"r-omega", {"\\romega"}},
                                                   {"r-p", {"\\rp"}},
                                                   {"r-epsilon", {"\\reps"}},
                                                   {"r-epsilon-omega-first", {"\\omegafirst"}}};
  const auto known = commands.find(formulation);
  return known == commands.end() ? text(formulation) : known->second;
}

Tex headings_over(const std::vector<std::string>& formulations, std::size_t columns) {
  std::string line = "&";
  for (const std::string& formulation : formulations)
    line += fmt::format(" & \\multicolumn{{{}}}{{c}}{{{}}}", columns, heading(formulation).source);
  return {line + " \\\\"};
}

}  // namespace trivium::paper
