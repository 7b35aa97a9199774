/// Declares the options that name a scene, and loads the scene with its model.

#include "trivium/command/scene_argument.hpp"

#include <fmt/format.h>

#include "base/command_line.hpp"
#include "formulations/analysis/assemble.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/scene_state.hpp"

namespace trivium {

void add_scene_options(ProgramOptions& options, SceneArguments& arguments) {
  options.add_option("SCENE", &arguments.scene, "A scene file, or the name of a catalogue scene").required();
  options
      .add_option("--t", &arguments.t,
                  "Time of the state in the file [s] (default: the time of a saved run, else 0)")
      .check(finite_time());
  options
      .add_option("--rank-tolerance", &arguments.rank_tolerance,
                  fmt::format("A row is dependent if less than this share of its gradient is independent of "
                              "the other rows, {:.0e} to {:.0e} (default: {:.0e}; simulate and compare "
                              "accept no smaller value)",
                              least_rank_tolerance, largest_rank_tolerance, standard_rank_tolerance))
      .check(number_between(least_rank_tolerance, largest_rank_tolerance));
  const ProgramOption assemble =
      options.add_flag("--assemble", &arguments.assemble, "First project the state onto its constraints");
  options.add_option("--save", &arguments.save, "With --assemble: write the assembled scene to this file")
      .check(writable_file())
      .needs(assemble);
}

LoadedScene load(const SceneArguments& arguments) {
  scenes::Scene scene = load_scene(arguments.scene, arguments.t);
  const double t = scenes::time_of(scene, arguments.t);
  if (arguments.rank_tolerance) scene.rank_tolerance = *arguments.rank_tolerance;
  Model<double> model = make_model<double>(scene, t);
  if (arguments.assemble) {
    set_state(scene, assemble(model.mechanism, model.state));
    if (!arguments.save.empty()) scenes::write_scene_file(arguments.save, scene);
    model.state = make_state<double>(scene, t);  // with the rounding of the scene, as a saved file would give
  }
  return {std::move(scene), std::move(model)};
}

}  // namespace trivium
