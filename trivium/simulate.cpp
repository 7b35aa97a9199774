/// Checks the settings and turns them into the library's options, also for compare(). Results are converted
/// to plain types output by output.

#include "trivium/simulate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>

#include "integrators/methods.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/motion_warnings.hpp"
#include "trivium/choices.hpp"
#include "trivium/plain.hpp"
#include "trivium/run_end.hpp"
#include "trivium/scene_contents.hpp"
#include "trivium/simulation_options.hpp"
#include "trivium/state_check.hpp"

namespace trivium {

namespace {

/// Throws an Error of kind input for a number that the command line would not accept either.
void check_settings(const SimulateSettings& s) {
  const auto require = [](bool holds, const char* setting, double found, const char* accepted) {
    if (!holds)
      throw Error(ErrorKind::input, fmt::format("{}: found {}; accepted: {}", setting, found, accepted));
  };
  const auto positive = [&](const char* setting, double x) {
    require(x > 0 && std::isfinite(x), setting, x, "a finite number above 0");
  };
  require(std::isfinite(s.end), "end", s.end, "a finite time");
  positive("rtol", s.rtol);
  positive("atol", s.atol);
  if (s.step) positive("step", *s.step);
  if (s.max_step) positive("max_step", *s.max_step);
  if (s.output_step) positive("output_step", *s.output_step);
  if (!s.baumgarte) return;
  for (const double x : *s.baumgarte)
    require(x >= 0 && std::isfinite(x), "baumgarte", x, "finite numbers not below 0");
  if (!s.projects)
    throw Error(ErrorKind::input,
                "projects: found false; accepted: true, since baumgarte already replaces the projection");
}

}  // namespace

SimulationOptions simulation_options(const SimulateSettings& s) {
  check_settings(s);
  SimulationOptions o;
  require_formulation(s.formulation);
  o.formulation = s.formulation;
  if (!integrators::find_method(s.integrator))
    refuse_name("integrator", s.integrator, integrators::method_names());
  o.integrator = s.integrator;
  o.end = s.end;
  o.step = s.step;
  o.max_step = s.max_step;
  o.output_step = s.output_step;
  o.tolerances = {s.rtol, s.atol};
  o.parameters.order = s.order;
  o.parameters.rho = s.rho;
  o.parameters.alpha = s.alpha;
  if (s.full_newton) o.parameters.full_newton = true;
  o.projects = s.projects && !s.baumgarte;
  if (s.baumgarte) o.baumgarte = Baumgarte{(*s.baumgarte)[0], (*s.baumgarte)[1]};
  o.charts = chart_options(s.sequence, s.reframe);
  return o;
}

namespace {

/// Converts every sample to a plain Output, and passes it to the user's observer, or keeps it without one.
class PlainObserver : public SimulationObserver {
 public:
  PlainObserver(const Mechanism<double>& mechanism, const SimulateSettings& settings,
                const Observer& observer)
      : names_(std::make_shared<const Names>(names_of(mechanism))),
        settings_(settings),
        observer_(observer) {}

  bool sample(const MotionSample& s) override {
    Output out;
    out.names = names_;
    out.t = s.state.t;
    out.bodies = plain_bodies(s.state, s.r_ddot, s.omega_bar_dot);
    out.lambda = plain(s.lambda);
    for (const Reaction<double>& reaction : s.reactions) out.reactions.push_back(plain(reaction));
    out.lambda_is_unique = s.lambda_unique;
    out.lambda_error = s.lambda_error;
    out.acceleration_error = s.acceleration_error;
    out.charts = s.charts;
    out.raw_lambda = plain(s.raw_lambda);
    out.energy = s.energy;
    out.phi = s.phi;
    out.phi_dot = s.phi_dot;
    if (observer_) return guarded([&] { return observer_(out); });
    kept.push_back(std::move(out));
    return true;
  }
  bool step(double t) override {
    return guarded([&] { return !settings_.at_step || settings_.at_step(t); });
  }

  std::vector<Output> kept;
  std::exception_ptr thrown;  ///< by the user's functions

 private:
  /// An exception of the user ends the run and is kept, so that it is not taken for an error of the run.
  template <class Work>
  bool guarded(const Work& work) {
    try {
      return work();
    } catch (...) {
      thrown = std::current_exception();
      return false;
    }
  }

  const std::shared_ptr<const Names> names_;
  const SimulateSettings& settings_;
  const Observer& observer_;
};

}  // namespace

Motion simulate(const Scene& scene, const SimulateSettings& settings, const Observer& observer) {
  const Scene::Contents& of = scene.contents();
  std::exception_ptr thrown;
  Motion motion = naming_errors(of.source, [&] {
    const Model<double> model = make_model<double>(of.scene, of.t);
    SimulationOptions options = simulation_options(settings);
    options.from = of.scene.saved;
    require_consistent(of.source, model, options.from, options.formulation);
    PlainObserver plain_observer(model.mechanism, settings, observer);
    const SimulationReport r = simulate(model, options, plain_observer);
    thrown = plain_observer.thrown;
    auto end = std::make_shared<Scene::Contents>(of);
    set_end(end->scene, r.end);
    end->t = r.end.run.t;
    Motion out;
    out.formulation = options.formulation;
    out.integrator = options.integrator;
    out.end = Scene(std::move(end));
    out.reached = r.reached;
    out.complete = r.complete;
    out.outputs = std::move(plain_observer.kept);
    out.steps = r.counters.steps;
    out.rejected_steps = r.counters.rejected_steps;
    out.right_sides = r.counters.right_sides;
    out.newton_iterations = r.counters.iterations;
    out.factorisations = r.factorisations;
    out.chart_changes = r.reframings;
    out.phi = r.phi;
    out.phi_dot = r.phi_dot;
    out.normalisation = r.normalisation;
    out.energy_start = r.energy_start;
    out.energy_end = r.energy_end;
    out.work = r.work;
    out.unaccounted_energy = r.unaccounted_energy;
    for (const SingularPassage& passage : r.passages) out.singular_positions.push_back(passage.t);
    for (const Impulse<double>& impulse : r.impulses) out.jumps.push_back({impulse.t, plain(impulse.lambda)});
    out.seconds = r.seconds;
    out.warnings = warnings_of(r);
    return out;
  });
  if (thrown) std::rethrow_exception(thrown);
  return motion;
}

}  // namespace trivium
