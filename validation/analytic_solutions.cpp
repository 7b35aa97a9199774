/// Question: does a motion agree with the solutions that are known in closed form, and with the curves of an
/// independent code? Every problem is solved in every formulation by Fehlberg's method at tight tolerance.
/// The program fails if the largest error of a quantity over a run exceeds the bound of this quantity
/// (validation/analytic/).

#include <fmt/format.h>

#include <algorithm>

#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "bodies/rotations/so3.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/side_by_side.hpp"
#include "validation/analytic/problems.hpp"
#include "validation/harness/program.hpp"

namespace trivium::analytic {

namespace {

std::string text(const std::vector<Check>& checks) {
  std::vector<std::string> header{"problem", "quantity"};
  for (const std::string& name : formulation_names()) header.push_back(name);
  header.insert(header.end(), {"bound", "verdict"});
  Table table(header);
  const std::size_t n = formulation_names().size();
  for (std::size_t first = 0; first < checks.size(); first += n) {
    std::vector<std::string> row{checks[first].problem, checks[first].quantity};
    bool passed = true;
    for (std::size_t k = first; k < first + n; ++k) {
      row.push_back(fmt::format("{:.1e}", checks[k].error));
      passed = passed && checks[k].passed();
    }
    row.push_back(fmt::format("{:.0e}", checks[first].bound));
    row.push_back(passed ? "ok" : "EXCEEDS");
    table.add(row);
  }
  return table.text();
}

std::string json(const std::vector<Check>& checks, bool passed) {
  JsonWriter out;
  out.begin_object().flag("passed", passed).begin_array("checks");
  for (const Check& c : checks)
    out.begin_object()
        .text("problem", c.problem)
        .text("formulation", c.formulation)
        .text("quantity", c.quantity)
        .number("error", c.error)
        .number("bound", c.bound)
        .flag("passed", c.passed())
        .end_object();
  return out.end_array().end_object().str();
}

int run(const Program& program) {
  const std::vector<Problem> all = problems();
  const std::vector<std::string> formulations = formulation_names();
  std::vector<Check> checks;
  Progress progress("analytic_solutions", all.size() * formulations.size());
  for (const Problem& problem : all) {
    std::vector<Errors> errors(formulations.size());
    for (std::size_t f = 0; f < formulations.size(); ++f) {
      problem.compare(formulations[f], errors[f]);
      progress.step();
    }
    for (std::size_t q = 0; q < errors[0].checks.size(); ++q)
      for (std::size_t f = 0; f < formulations.size(); ++f) {
        Check check = errors[f].checks[q];
        check.problem = problem.name;
        check.formulation = formulations[f];
        checks.push_back(check);
      }
  }
  const bool passed = std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.passed(); });
  ResultsFile file("analytic_solutions", {"problem", "formulation", "quantity", "error", "bound", "verdict"});
  for (const Check& c : checks)
    file.add({c.problem, c.formulation, c.quantity, results_number(c.error), results_number(c.bound),
              c.passed() ? "ok" : "EXCEEDS"});
  program.write(file);
  fmt::print("{}", program.json() ? json(checks, passed) : text(checks));
  return batch_exit(true, passed);
}

}  // namespace

}  // namespace trivium::analytic

int main(int argc, char** argv) {
  using namespace trivium;
  Program program(
      "Does the motion agree with closed-form solutions, and with curves of an independent program? Computes "
      "all problems that have a known solution.",
      "analytic_solutions", "");
  return program.run(argc, argv, [&] { return analytic::run(program); });
}
