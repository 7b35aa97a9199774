/// Question: does every method converge with its published order, in every formulation? The program halves
/// the step size and compares positions, velocities, lambda of the state and the method's raw lambda with a
/// reference. Runs are in quad if the method allows it, so that rounding hides no error. The program fails if
/// a run fails, if no order is observed, or if an observed order differs from the published order by more
/// than 0.2.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "bodies/numbers/quad.hpp"
#include "formulations/side_by_side.hpp"
#include "integrators/methods.hpp"
#include "validation/convergence/plot.hpp"
#include "validation/harness/program.hpp"

namespace trivium::convergence {

namespace {

/// Names the methods that are left out, because they choose their step size.
std::string not_here() {
  std::vector<std::string_view> names;
  for (const integrators::MethodInfo& method : integrators::methods())
    if (!method.takes_given_steps) names.push_back(method.name);
  return fmt::format(
      "{} control step size and order by tolerances, so no order can be observed; work_precision\nshows "
      "their errors.\n",
      fmt::join(names, ", "));
}

std::vector<std::string> columns() {
  return {"scene", "formulation", "method", "quantity", "h", "error", "order", "published", "verdict"};
}

std::string text(const std::vector<OrderResult>& rows) {
  std::string out;
  ErrorLines errors;
  for (std::size_t first = 0; first < rows.size();) {
    Table table({"method", "formulation", "published", "r", "v", "lambda", "raw lambda", "verdict"});
    const std::string& scene = rows[first].scene;
    for (; first < rows.size() && rows[first].scene == scene; ++first) {
      const OrderResult& row = rows[first];
      std::vector<std::string> line{row.of.label, row.formulation, std::to_string(row.published(0))};
      for (int k = 0; k < 4; ++k)
        line.push_back(!row.solved() || !row.has(k) ? "-"
                       : !row.is_known(k)           ? "unknown"
                       : row.is_rounding(k)
                           ? fmt::format("rounding ({:.0e})", row.errors.back()[k])
                           : fmt::format("{:.2f} ({:.0e})", row.observed(k), row.errors[row.level(k)][k]));
      line.push_back(!row.solved() ? "ERROR" : row.passed() ? "ok" : "DIFFERS");
      table.add(line);
      if (!row.solved()) errors.add(row.error, row.formulation + ", " + row.of.label);
    }
    out += fmt::format(
        "{}: observed orders; in brackets the error at the smallest step whose error is above "
        "rounding\n\n{}\n",
        scene, table.text());
  }
  return out + errors.text() + not_here();
}

std::string json(const std::vector<OrderResult>& rows, bool passed) {
  JsonWriter out;
  out.begin_object().flag("passed", passed).begin_array("orders");
  for (const OrderResult& row : rows) {
    out.begin_object()
        .text("scene", row.scene)
        .text("formulation", row.formulation)
        .text("method", row.of.label);
    if (row.solved())
      for (int k = 0; k < 4; ++k)
        if (row.has(k) && row.is_known(k) && !row.is_rounding(k)) out.number(quantities[k], row.observed(k));
    out.number("published", row.of.order).flag("passed", row.passed());
    if (!row.solved()) out.text("error", row.error);
    out.end_object();
  }
  return out.end_array().end_object().str();
}

struct Options {
  double t_end = 0.1;
  int levels = 3;
  std::string plot, plotted = "r-omega";
  std::vector<std::string> methods;
};

int run(const Program& program, const Options& options) {
  std::vector<Case> chosen = cases();
  if (!options.methods.empty())
    std::erase_if(chosen, [&](const Case& c) {
      return std::find(options.methods.begin(), options.methods.end(), c.method) == options.methods.end();
    });
  if (chosen.empty()) {
    fmt::print(stderr, "error: {}", not_here());
    return exit_input_error;
  }
  std::vector<NamedScene> scenes = program.scenes(0);
  if (!program.names_scenes())
    std::erase_if(scenes, [&](const NamedScene& s) {
      return std::ranges::count(chosen, s.scene.name, &Case::scene) == 0;
    });
  std::vector<OrderResult> rows;
  Progress progress("convergence_order", scenes.size() * formulation_names().size() * chosen.size());
  bool solved = true, passed = true;
  for (const NamedScene& named : scenes) {
    SimulationOptions reference;
    reference.integrator = "rkf78";
    reference.end = options.t_end;
    reference.tolerances = {1e-19, 1e-21};  // far below the least floor of the observed errors, 5e-18
    std::optional<TwoModels> models;
    std::vector<MotionSample> exact;
    std::string error;
    try {
      models.emplace(named);
      exact = outputs_of(*models, reference);
    } catch (const std::runtime_error& of_reference) {
      error =
          name_source(named.source, fmt::format("the reference solution failed: {}", of_reference.what()));
    }
    for (const Case& of : chosen)
      for (const std::string& formulation : formulation_names()) {
        progress.step();
        if (!goes_with(*integrators::find_method(of.method), formulation)) continue;
        if (!program.names_scenes() && of.scene != named.scene.name) continue;
        rows.push_back(error.empty() ? measure(*models, formulation, of, options.t_end, options.levels, exact)
                                     : OrderResult{named.scene.name, formulation, error, of, {}, {}, {}});
        solved = solved && rows.back().solved();
        passed = passed && rows.back().passed();
      }
  }
  ResultsFile file("convergence_order", columns());
  for (const OrderResult& row : rows)
    for (int k = 0; k < 4; ++k)
      for (std::size_t level = 0; row.solved() && row.has(k) && level < row.h.size(); ++level)
        file.add({row.scene, row.formulation, row.of.label, quantities[k], results_number(row.h[level]),
                  results_number(row.errors[level][k]),
                  level > 0 && level <= row.level(k) ? results_number(row.observed(k, level)) : "none",
                  std::to_string(row.published(k)),
                  level + 1 < row.h.size() ? "none"
                  : row.passed(k)          ? "ok"
                                           : "DIFFERS"});
  program.write(file);
  if (!options.plot.empty() && !rows.empty()) plot(rows, rows.front().scene, options.plotted, options.plot);
  fmt::print("{}", program.json() ? json(rows, passed) : text(rows));
  return batch_exit(solved, passed);
}

}  // namespace

}  // namespace trivium::convergence

int main(int argc, char** argv) {
  using namespace trivium;
  Program program("Does every method converge with its published order, in every formulation?",
                  "convergence_order", "spatial_slider_crank, and double_pendulum for hedop5");
  convergence::Options options;
  program.options().add_option("--t-end", &options.t_end, "End of the runs [s]").show_default();
  program.options()
      .add_option("--levels", &options.levels, "Number of step sizes, each half of the previous one")
      .between(2, 8)
      .show_default();
  program.options()
      .add_option("--method", &options.methods, "Only these methods")
      .one_of(integrators::method_names());
  program.options().add_option("--plot", &options.plot,
                               "Draw the errors over the step size to this SVG file");
  program.options()
      .add_option("--plotted", &options.plotted, "Formulation in the figure")
      .one_of(formulation_names())
      .show_default();
  return program.run(argc, argv, [&] { return convergence::run(program, options); });
}
