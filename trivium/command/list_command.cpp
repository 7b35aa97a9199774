/// trivium list: the scenes of the catalogue, formulations, integrators, constraints and effects.

#include <fmt/format.h>

#include <memory>

#include "base/exit_code.hpp"
#include "base/json_writer.hpp"
#include "base/number_text.hpp"
#include "formulations/formulation_list.hpp"
#include "integrators/methods.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/format/scene_keys.hpp"
#include "trivium/command/commands.hpp"

namespace trivium {

namespace {

template <class Shapes>
std::vector<std::string> types_of(const Shapes& shapes) {
  const auto names = scenes::names_of(shapes);
  return {names.begin(), names.end()};
}

int run_list(bool json) {
  std::vector<scenes::Scene> all;
  for (const auto& file : catalogue()) all.push_back(scenes::read_scene_file(file));
  if (json) {
    JsonWriter out;
    out.begin_object().begin_array("scenes");
    for (const scenes::Scene& scene : all)
      out.begin_object()
          .text("name", scene.name)
          .text("description", scene.description)
          .text("reference", scene.reference)
          .number("nb", scene.bodies.size())
          .end_object();
    out.end_array()
        .texts("formulations", formulation_names())
        .texts("integrators", integrators::method_names())
        .texts("constraints", types_of(scenes::constraint_shapes()))
        .texts("effects", types_of(scenes::effect_shapes()))
        .end_object();
    fmt::print("{}", out.str());
    return exit_done;
  }
  fmt::print("scenes ({})\n", catalogue_directory().string());
  for (const scenes::Scene& scene : all)
    fmt::print("  {:<28} {:>10}  {}\n", scene.name, counted(scene.bodies.size(), "body", "bodies"),
               scene.description);
  fmt::print("\nformulations  {}\n", fmt::join(formulation_names(), ", "));
  fmt::print("integrators   {}\n", fmt::join(integrators::method_names(), ", "));
  fmt::print("constraints   {}\n", fmt::join(types_of(scenes::constraint_shapes()), ", "));
  fmt::print("effects       {}\n", fmt::join(types_of(scenes::effect_shapes()), ", "));
  return exit_done;
}

}  // namespace

Command add_list_command(ProgramOptions& program) {
  auto json = std::make_shared<bool>(false);
  ProgramOptions options =
      program.add_subcommand("list", "Scenes, formulations, integrators, constraints and effects");
  options.add_flag("--json", json.get(), "JSON on stdout");
  return {options, [json] { return run_list(*json); }};
}

}  // namespace trivium
