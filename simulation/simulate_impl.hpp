#pragma once
/// The definition of simulate_in, for every formulation and Scalar. It sets up the equations, the method and
/// the watch, integrates, and fills the report.

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <type_traits>

#include "bodies/numbers/scalar.hpp"
#include "integrators/integrate.hpp"
#include "integrators/methods.hpp"
#include "simulation/cpu_time.hpp"
#include "simulation/motion_watch.hpp"
#include "simulation/simulate_in.hpp"

namespace trivium {

namespace detail {

/// The equations, the method and the report of one run.
template <Formulation F>
class Simulation {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  Simulation(const ModelOf<F>& model, const SimulationOptions& options, SimulationObserver& observer)
      : start_(model.state.t),
        options_(options),
        observer_(observer),
        entry_(entry_of(options)),
        is_implicit_(is_implicit(entry_.info, options)),
        projects_(options.projects && !is_implicit_),
        depends_on_time_(model.mechanism.depends_on_time()),
        method_(make_method()),
        equations_(model.mechanism, model.state,
                   {options.charts, options.baumgarte, projects_ || is_implicit_, saved_run(options)}) {}

  SimulationReport run() {
    using namespace integrators;
    const SavedRun* const from = saved_run(options_);
    const double begin = static_cast<double>(start_);
    TimeGrid grid(from ? from->start : begin, options_.end, options_.output_step, options_.step,
                  equations_.first_order().mechanism().kinks());
    if (options_.max_step) grid = grid.limited_to(*options_.max_step);
    if (from) grid = grid.from(begin);
    SystemAdapter<ConstrainedEquations<F>> system(equations_);
    MotionWatch<F> watch(equations_, *method_, options_, observer_, report_, start_, step_errors(system));
    ProjectionReport<S> projection;
    if (from && from->integrator == entry_.info.name && options_.step) recall(system, *from);
    S end_t = start_;
    StateVector end_y;
    const double start = cpu_seconds();
    report_.complete = integrate<S>(
        system, *method_, grid, projects_, projection,
        [&](const S& t, const StateVector& y) {
          report_.reached = static_cast<double>(t);
          if (options_.watches) watch.watch(t, y);
          return observer_.step(report_.reached) ? Continue::yes : Continue::no;
        },
        [&](const S& t, const StateVector& y) {
          const bool goes_on = options_.watches ? watch.show(t, y) : watch.show_state(t, y);
          end_t = t;
          end_y = y;
          return goes_on ? Continue::yes : Continue::no;
        });
    report_.seconds = cpu_seconds() - start;
    report_.end = watch.end(S(grid.start()), end_t, end_y);
    report_.end.run.integrator = entry_.info.name;
    report_.end.run.memory = method_->memory();
    report_the_run(projection);
    return report_;
  }

 private:
  static integrators::MethodEntry<S> entry_of(const SimulationOptions& options) {
    if (!options.own_method) return integrators::method_entry<S>(options.integrator);
    if constexpr (std::is_same_v<S, double>)
      return *options.own_method;
    else
      throw integrators::UsageError("a method given as own_method computes in double precision only");
  }

  /// Whether the method satisfies the position constraints by its own equations. Throws a UsageError if
  /// projection or Baumgarte's stabilisation was requested in a way that contradicts the method.
  static bool is_implicit(const integrators::MethodInfo& method, const SimulationOptions& options) {
    const bool is = method.meets_constraints;
    if (is && !options.projects && !options.baumgarte)
      throw integrators::UsageError(fmt::format(
          "{} satisfies the constraints by its own equations: there is no projection to switch off",
          method.name));
    if (is && options.baumgarte)
      throw integrators::UsageError(
          fmt::format("{} solves for positions on the constraints: Baumgarte's stabilisation cannot be used",
                      method.name));
    if (method.has_raw_lambda && options.baumgarte)
      throw integrators::UsageError(
          fmt::format("{} satisfies the velocity constraints by its own multipliers: Baumgarte's "
                      "stabilisation of accelerations cannot be used",
                      method.name));
    return is;
  }

  static const SavedRun* saved_run(const SimulationOptions& options) {
    return options.from && options.from->formulation == F::name ? &*options.from : nullptr;
  }

  std::unique_ptr<integrators::AnyMethod<S>> make_method() const {
    integrators::MethodParameters given = options_.parameters;
    given.projects = projects_;
    given.depends_on_time = depends_on_time_;
    return integrators::make_method<S>(entry_,
                                       options_.step ? integrators::Steps::given : integrators::Steps::chosen,
                                       options_.tolerances, given);
  }
  /// The errors of given steps, if the order of the method is known.
  std::optional<StepErrors<F>> step_errors(integrators::AnySystem<S>& system) {
    const int order = options_.parameters.order.value_or(entry_.info.standard_order);
    if (!options_.step || order < 1) return {};
    return StepErrors<F>(equations_, *method_, order, is_implicit_,
                         HalvedSteps<S>(system, make_method(), projects_));
  }
  /// Gives the method the memory of the saved run, such as an auxiliary acceleration.
  void recall(integrators::AnySystem<S>& system, const SavedRun& from) {
    if (from.memory.empty()) return;
    try {
      method_->recall(system, start_, system.start(), start_ + S(*options_.step), from.memory);
    } catch (const std::invalid_argument& error) {
      throw integrators::UsageError(
          fmt::format("the memory of the saved run is not valid for the method {}: {}; leave out the key "
                      "\"memory\" to start the method anew",
                      entry_.info.name, error.what()));
    }
  }

  void report_the_run(const integrators::ProjectionReport<S>& projection) {
    report_.is_projected = projects_;
    report_.is_implicit = is_implicit_;
    report_.has_raw_lambda = entry_.info.has_raw_lambda;
    report_.counters = method_->counters();
    report_.factorisations = equations_.factorisations();
    report_.jacobians = equations_.newton_matrices();
    report_.reframings = equations_.first_order().reframings();
    const MotionLog<S>& log = equations_.first_order().log();
    report_.passages = log.passages();
    for (const Impulse<S>& impulse : log.impulses())
      report_.impulses.push_back({impulse.t, scalar_cast<double>(impulse.lambda)});
    report_.projection = {static_cast<double>(projection.position), static_cast<double>(projection.velocity),
                          static_cast<double>(projection.position_left),
                          static_cast<double>(projection.velocity_left), projection.changes};
  }

  const S start_;
  const SimulationOptions& options_;
  SimulationObserver& observer_;
  const integrators::MethodEntry<S> entry_;
  const bool is_implicit_, projects_, depends_on_time_;
  std::unique_ptr<integrators::AnyMethod<S>> method_;
  ConstrainedEquations<F> equations_;
  SimulationReport report_;
};

}  // namespace detail

template <Formulation F>
SimulationReport simulate_in(const ModelOf<F>& model, const SimulationOptions& options,
                             SimulationObserver& observer) {
  return detail::Simulation<F>(model, options, observer).run();
}

}  // namespace trivium
