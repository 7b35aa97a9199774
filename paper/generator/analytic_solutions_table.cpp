/// One line for each quantity of a problem: its largest error in every formulation, and the bound on the
/// error.

#include "paper/generator/formulations.hpp"
#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

/// A quantity with its unit; ^2 becomes a superscript.
Tex quantity(const std::string& plain) {
  const std::size_t square = plain.find("^2");
  if (square == std::string::npos) return text(plain);
  return {text(plain.substr(0, square)).source + "\\textsuperscript{2}" +
          text(plain.substr(square + 2)).source};
}

}  // namespace

std::string analytic_solutions_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["analytic_solutions"];
  const std::vector<std::string> formulations = formulations_of(table);
  const std::size_t n = formulations.size();
  std::vector<TexColumn> columns{{"l", {"problem"}}, {"l", {"error of"}}};
  for (const std::string& formulation : formulations) columns.push_back({scientific, heading(formulation)});
  columns.push_back({scientific, {"bound"}});
  TexTable out(columns);
  std::size_t failed = 0;
  Sample closed_forms;
  std::string last;
  for (std::size_t first = 0; first < table.rows.size(); first += n) {
    const std::string& problem = table.text(first, "problem");
    if (!last.empty() && problem != last) out.rule();
    std::vector<Tex> cells{text(problem == last ? "" : problem), quantity(table.text(first, "quantity"))};
    last = problem;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t row = first + k;
      if (table.text(row, "formulation") != formulations[k] || table.text(row, "problem") != problem)
        throw ResultsError("analytic_solutions: the rows of " + problem + " are out of order");
      if (table.text(row, "verdict") != "ok") ++failed;
      cells.push_back(number(table.number(row, "error")));
      if (!problem.starts_with("adams")) closed_forms.add(table.number(row, "error"), problem);
    }
    cells.push_back(number(table.number(first, "bound")));
    out.add(cells);
  }
  numbers.define("ClosedFormsWorst", in_text(closed_forms.worst()));
  numbers.define("ClosedFormsWorstProblem", text(closed_forms.worst_name()));
  numbers.define("ClosedFormsFailed", integer(failed));
  return out.str("results/analytic_solutions.csv");
}

}  // namespace trivium::paper
