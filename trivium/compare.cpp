/// Settings and results are converted between the public types and those of simulation/motion_comparison.hpp,
/// which makes the comparison.

#include "trivium/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formulations/formulation_list.hpp"
#include "integrators/methods.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/motion_comparison.hpp"
#include "simulation/motion_warnings.hpp"
#include "trivium/choices.hpp"
#include "trivium/scene_contents.hpp"
#include "trivium/simulation_options.hpp"
#include "trivium/state_check.hpp"

namespace trivium {

std::vector<ComparedFormulation> formulations_to_compare(const std::vector<std::string>& names,
                                                         const std::string& integrator, std::size_t least) {
  for (const std::string& name : names) require_formulation(name);
  std::vector<ComparedFormulation> all = compared_formulations(names, *integrators::find_method(integrator));
  if (all.size() < least)
    throw Error(ErrorKind::input,
                fmt::format("{} to compare; accepted: at least {} of {} that the method {} supports",
                            all.empty() ? "no formulation" : "only one formulation",
                            least == 1 ? "one" : "two", fmt::join(formulation_names(), ", "), integrator));
  return all;
}

namespace {

ComparedMotion plain(const ComparedRun& run) {
  const SimulationReport& r = run.report;
  return {run.formulation,
          run.error,
          run.charts,
          r.counters.steps,
          r.counters.rejected_steps,
          r.counters.right_sides,
          r.counters.iterations,
          r.factorisations,
          r.reframings,
          r.seconds,
          run.error.empty() ? warnings_of(r) : std::vector<std::string>()};
}

ComparedOutput plain(const MotionComparison& comparison, const ComparedInstant& now) {
  ComparedOutput out{now.t,        now.lambda,   now.lambda_bound,          now.amplification,
                     now.position, now.rotation, comparison.is_judged(now), {}};
  if (const auto& at = now.one_state) out.one_state = {at->lambda, at->bound, at->acceleration, at->kappa};
  return out;
}

}  // namespace

ComparedMotions compare(const Scene& scene, const CompareSettings& settings) {
  const Scene::Contents& of = scene.contents();
  return naming_errors(of.source, [&] {
    const Model<double> model = make_model<double>(of.scene, of.t);
    ComparisonOptions options;
    options.run = simulation_options(settings.run);
    options.states = settings.states;
    if (settings.states < 1)
      throw Error(ErrorKind::input, fmt::format("states: found {}; accepted: at least 1", settings.states));
    require_consistent(of.source, model, of.scene.saved);
    const auto formulations = formulations_to_compare(settings.formulations, options.run.integrator);
    const MotionComparison comparison = compare_motion(formulations, model, options);
    ComparedMotions out;
    for (const ComparedRun& run : comparison.runs) out.motions.push_back(plain(run));
    for (const ComparedInstant& now : comparison.instants) out.outputs.push_back(plain(comparison, now));
    out.has_unique_lambda = comparison.has_unique_lambda;
    out.complete = comparison.complete();
    out.holds_along = comparison.holds_along();
    out.holds_at_states = comparison.holds_at_states();
    return out;
  });
}

}  // namespace trivium
