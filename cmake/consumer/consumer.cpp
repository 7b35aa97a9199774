/// What a user of the installed headers writes: a scene from a file, one formulation, its multipliers.

#include <fmt/format.h>
#include <formulations/printed/augmented_solver.hpp>
#include <formulations/r_p.hpp>
#include <scenes/format/scene_file.hpp>

#include "scenes/make_mechanism.hpp"

int main(int, char** argv) {
  using namespace trivium;
  const scenes::Scene scene = scenes::read_scene_file(argv[1]);
  const auto mechanism = make_mechanism<double>(scene);
  const auto state = make_state<double>(scene);
  const RowAnalysis rows = analyse_rows(tangent_system(mechanism, state));
  AugmentedSolver<RP<double>> solver(mechanism, state, rows);
  const PhysicalSolution<double> solution = solver.accelerations_of(solver.solve());
  for (int k = 0; k < mechanism.nc(); ++k) fmt::print("{} {}\n", mechanism.row_names[k], solution.lambda[k]);
  return mechanism.nc() > 0 && solution.lambda.allFinite() ? 0 : 1;
}
