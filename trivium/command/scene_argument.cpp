#include "trivium/command/scene_argument.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "base/command_line.hpp"
#include "base/error.hpp"
#include "formulations/analysis/assemble.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/scene_state.hpp"

namespace trivium {

void add_scene_options(ProgramOptions& options, SceneArguments& arguments) {
  options.add_option("SCENE", &arguments.scene, "A scene file, or the name of a catalogue scene").required();
  options.add_option("--t", &arguments.t, "The time at which the file's state is taken [s]")
      .check(finite_time())
      .show_default();
  const ProgramOption assemble =
      options.add_flag("--assemble", &arguments.assemble, "First project the state onto its constraints");
  options.add_option("--save", &arguments.save, "With --assemble: write the assembled scene to this file")
      .check(writable_file())
      .needs(assemble);
}

LoadedScene load(const SceneArguments& arguments) {
  scenes::Scene scene = load_scene(arguments.scene, arguments.t);
  Model<double> model = make_model<double>(scene, arguments.t);
  if (arguments.assemble) {
    set_state(scene, assemble(model.mechanism, model.state));
    if (!arguments.save.empty()) scenes::write_scene_file(arguments.save, scene);
    model.state = make_state<double>(scene, arguments.t);  // as the file has it
  }
  return {std::move(scene), std::move(model)};
}

bool report_consistency(const SceneArguments& arguments, const Consistency& consistency) {
  if (consistency.holds()) return true;
  fmt::print(stderr, "error: {}: the state at t = {} does not satisfy its constraints:\n{}", arguments.scene,
             arguments.t, consistency.report());
  if (!consistency.holds_rows()) fmt::print(stderr, "--assemble projects it onto them\n");
  if (!consistency.wrong_branches.empty()) fmt::print(stderr, "{}\n", wrong_branch_advice);
  return false;
}

int naming_scene(const SceneArguments& arguments, const std::function<int()>& run) {
  try {
    return run();
  } catch (const ModelError& error) {
    throw ModelError(name_source(arguments.scene, error.what()));
  }
}

}  // namespace trivium
