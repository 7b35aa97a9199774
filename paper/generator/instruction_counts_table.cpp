/// One line for each mechanism: instructions per body in every formulation, without and with refinement.

#include <cmath>

#include "paper/generator/formulations.hpp"
#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

const std::vector<std::string> refinements{"none", "once"};

Tex whole(double n) { return integer(static_cast<std::size_t>(std::llround(n))); }

}  // namespace

std::string instruction_counts_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["instruction_counts"];
  const std::vector<std::string> formulations = formulations_of(table, refinements.size());
  const std::size_t per_scene = formulations.size() * refinements.size();
  std::vector<TexColumn> columns{{"l", {"mechanism"}}, {"r", {"$n_b$"}}};
  for (std::size_t k = 0; k < formulations.size(); ++k) {
    columns.push_back({"r", {"unrefined"}});
    columns.push_back({"r", {"refined"}});
  }
  TexTable out(columns);
  out.head(headings_over(formulations, refinements.size()));

  Sample of_r_omega, refinement;  // ratio to r-omega, ratio to unrefined
  for (std::size_t first = 0; first < table.rows.size(); first += per_scene) {
    const std::string& scene = table.text(first, "scene");
    std::vector<Tex> cells{text(scene), text(table.text(first, "bodies"))};
    for (std::size_t k = 0; k < per_scene; ++k) {
      const std::size_t row = first + k, base = first + k % refinements.size();
      if (table.text(row, "scene") != scene ||
          table.text(row, "formulation") != formulations[k / refinements.size()] ||
          table.text(row, "refinement") != refinements[k % refinements.size()])
        throw ResultsError("instruction_counts: the rows of " + scene + " are out of order");
      const double count = table.number(row, "instructions_per_body");
      cells.push_back(whole(count));
      if (k >= refinements.size()) of_r_omega.add(count / table.number(base, "instructions_per_body"), scene);
      if (k % 2 == 1) refinement.add(count / table.number(row - 1, "instructions_per_body"), scene);
    }
    out.add(cells);
    if (scene == "chain_100") {
      numbers.define("InstructionsChain", whole(table.number(first, "instructions_per_body")));
      numbers.define("InstructionsChainRefined", whole(table.number(first + 1, "instructions_per_body")));
    }
  }
  numbers.define("InstructionsOfROmega", ratio_in_text(of_r_omega.worst()));
  numbers.define("InstructionsOfRefinement", ratio_in_text(refinement.worst()));
  return out.str("results/instruction_counts.csv");
}

}  // namespace trivium::paper
