/// What a user of the installed headers writes: the walk of a scene that README shows, from its file to its
/// motion.

#include <fmt/format.h>
#include <base/command_line.hpp>
#include <formulations/printed/augmented_solver.hpp>
#include <formulations/r_p.hpp>
#include <formulations/side_by_side.hpp>
#include <formulations/structured/acceleration_solver.hpp>
#include <scenes/format/scene_file.hpp>
#include <scenes/make_mechanism.hpp>
#include <simulation/simulate.hpp>

namespace {

int walk(const char* file) {
  using namespace trivium;
  const scenes::Scene scene = scenes::read_scene_file(file);
  const Model<double> model = make_model<double>(scene);
  const RowAnalysis rows = analyse_rows(model);
  const auto one = solve_printed<RP<double>>(model, rows);
  const SideBySide<double> all = side_by_side(model, rows);
  AccelerationSolver<RP<double>> solver(model.mechanism);
  solver.solve(to_coordinates<RP<double>>(model.mechanism, model.state, {}), model.state.t);
  Samples samples;
  simulate(model, {.formulation = "r-p", .integrator = "radau5", .end = 0.1}, samples);

  for (int k = 0; k < model.mechanism.nc(); ++k)
    fmt::print("{} {} {}\n", model.mechanism.row_names[k], one.lambda[k], solver.lambda()[k]);
  const bool is_done = one.lambda.size() > 0 && one.lambda.allFinite() && samples.all.size() == 2;
  return is_done && all.discrepancy().lambda <= all.lambda_bound() ? 0 : 1;
}

}  // namespace

int main(int, char** argv) {
  return trivium::run_guarded([&] { return walk(argv[1]); });
}
