#pragma once
/// The one definition behind the simulations in each formulation and Scalar.

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "bodies/numbers/scalar.hpp"
#include "formulations/joint_reaction.hpp"
#include "integrators/integrate.hpp"
#include "integrators/methods.hpp"
#include "simulation/cpu_time.hpp"
#include "simulation/simulate_in.hpp"
#include "simulation/system/constrained_equations.hpp"

namespace trivium {

namespace detail {

template <Formulation F>
class Simulation {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  Simulation(const Model<typename F::Scalar>& model, const SimulationOptions& options,
             SimulationObserver& observer)
      : start_(model.state.t),
        options_(options),
        observer_(observer),
        is_implicit_(is_implicit(options)),
        projects_(options.projects && !is_implicit_),
        method_(integrators::make_method<S>(
            options.integrator, options.step ? integrators::Steps::given : integrators::Steps::chosen,
            options.tolerances, parameters(options, projects_))),
        form_(model.mechanism, model.state, {options.charts, options.baumgarte, projects_ || is_implicit_}) {}

  SimulationReport run() {
    using namespace integrators;
    const TimeGrid grid(static_cast<double>(start_), options_.end, options_.output_step, options_.step,
                        form_.mechanism().kinks());
    SystemAdapter<ConstrainedEquations<F>> system(form_);
    ProjectionReport<S> projection;
    const MotionEnergy<S> at_start = form_.energy(start_, form_.start());
    report_.is_projected = projects_;
    report_.is_implicit = is_implicit_;
    if (const MethodInfo* method = find_method(options_.integrator))
      report_.has_own_lambda = method->has_own_lambda;
    report_.does_work = form_.does_work();
    report_.energy_start = static_cast<double>(at_start.total());
    const double start = cpu_seconds();
    report_.complete = integrate<S>(
        system, *method_, grid, projects_, projection,
        [&](const S& t, const StateVector& y) {
          report_.reached = static_cast<double>(t);
          if (options_.watches) watch(t, y, at_start);
          return observer_.step(report_.reached) ? Continue::yes : Continue::no;
        },
        [&](const S& t, const StateVector& y) {
          if (options_.watches)
            show(t, y, at_start);
          else
            observer_.sample({.state = state_at(t, y), .reactions = {}, .lambda = {}, .raw_lambda = {}});
        });
    report_.seconds = cpu_seconds() - start;
    report_.counters = method_->counters();
    report_.factorisations = form_.factorisations();
    report_.jacobians = form_.newton_matrices();
    report_.reframings = form_.reframings();
    report_.passages = form_.passages();
    for (const Impulse<S>& impulse : form_.impulses())
      report_.impulses.push_back({impulse.t, scalar_cast<double>(impulse.lambda)});
    report_.projection = {static_cast<double>(projection.position), static_cast<double>(projection.velocity),
                          static_cast<double>(projection.position_left),
                          static_cast<double>(projection.velocity_left), projection.changes};
    return report_;
  }

 private:
  /// Throws a UsageError where what is asked for does not go with it.
  static bool is_implicit(const SimulationOptions& options) {
    const integrators::MethodInfo* method = integrators::find_method(options.integrator);
    if (method == nullptr) return false;
    const bool is = method->meets_constraints;
    if (is && !options.projects && !options.baumgarte)
      throw integrators::UsageError(
          fmt::format("{} meets constraints by its own equations: there is no projection to leave out",
                      options.integrator));
    if (is && options.baumgarte)
      throw integrators::UsageError(fmt::format(
          "{} solves for positions on the constraints, which Baumgarte's stabilisation has no part in",
          options.integrator));
    if (method->has_own_lambda && options.baumgarte)
      throw integrators::UsageError(fmt::format(
          "{} meets the rows of velocities by its own multipliers, which Baumgarte's stabilisation "
          "of accelerations has no part in",
          options.integrator));
    return is;
  }

  static integrators::MethodParameters parameters(const SimulationOptions& options, bool projects) {
    integrators::MethodParameters given = options.parameters;
    given.projects = projects;
    return given;
  }

  /// What a state's report and sample both say.
  struct Seen {
    MotionEnergy<S> energy;
    double phi, phi_dot;
  };

  void show(const S& t, const StateVector& y, const MotionEnergy<S>& at_start) {
    const Seen seen = watch(t, y, at_start);
    MotionSample sample;
    sample.energy = static_cast<double>(seen.energy.total());
    sample.phi = seen.phi;
    sample.phi_dot = seen.phi_dot;
    const VectorX<S> lambda = lambda_at(t, y);
    sample.lambda = scalar_cast<double>(lambda);
    sample.lambda_rest = rest_of(lambda);
    if (const VectorX<S>* raw = method_->lambda()) {
      sample.raw_lambda = scalar_cast<double>(*raw);
      sample.raw_lambda_rest = rest_of(*raw);
      const VectorX<S> apart = *raw - form_.solved(t, y).lambda();
      if (apart.size() > 0)
        report_.lambda_gap = std::max(report_.lambda_gap, scalar_cast<double>(apart).cwiseAbs().maxCoeff());
    }
    const auto equations = equations_of_motion<F>(form_.mechanism(), form_.state(), t);
    for (const Joint<S>& joint : form_.mechanism().joints) {
      const Reaction<S> r =
          joint_reaction(equations, joint, lambda, End::j).about(joint_point(equations, joint));
      sample.reactions.push_back(
          {scalar_cast<double>(r.force), scalar_cast<double>(r.torque), scalar_cast<double>(r.point)});
    }
    sample.state = state_at(t, y);
    if constexpr (is_beyond_double)
      sample.state_rest = in_double(form_.to_mechanism_state(t, y), [](const auto& x) { return rest_of(x); });
    observer_.sample(sample);
  }

  MechanismState<double> state_at(const S& t, const StateVector& y) {
    return in_double(form_.to_mechanism_state(t, y), [](const auto& x) { return scalar_cast<double>(x); });
  }
  /// What `part` makes of each of its vectors.
  template <class Part>
  static MechanismState<double> in_double(const MechanismState<S>& state, const Part& part) {
    MechanismState<double> shown{static_cast<double>(state.t), {}, {}};
    for (const Pose<S>& pose : state.pose) shown.pose.push_back({part(pose.r), part(pose.p)});
    for (const Twist<S>& twist : state.twist)
      shown.twist.push_back({part(twist.r_dot), part(twist.omega_bar)});
    return shown;
  }
  static constexpr bool is_beyond_double =
      std::numeric_limits<S>::digits > std::numeric_limits<double>::digits;
  /// What double leaves of it; nothing where S is no more.
  static VectorX<double> rest_of(const VectorX<S>& x) {
    if constexpr (is_beyond_double)
      return scalar_cast<double>(VectorX<S>(x - scalar_cast<S>(scalar_cast<double>(x))));
    else
      return {};
  }

  /// What the report says of every state.
  Seen watch(const S& t, const StateVector& y, const MotionEnergy<S>& at_start) {
    const Seen seen{form_.energy(t, y), static_cast<double>(form_.position_violation(t, y)),
                    static_cast<double>(form_.velocity_violation(t, y))};
    const auto raise = [](double& largest, double now) {
      if (!(now <= largest)) largest = now;
    };
    using std::abs;
    raise(report_.normalisation, static_cast<double>(form_.normalisation_violation(y)));
    raise(report_.phi, seen.phi);
    raise(report_.phi_dot, seen.phi_dot);
    raise(report_.unaccounted_energy,
          static_cast<double>(S(abs(seen.energy.total() - at_start.total() - seen.energy.work))));
    raise(report_.largest_kinetic, static_cast<double>(seen.energy.kinetic));
    report_.energy_end = static_cast<double>(seen.energy.total());
    report_.work = static_cast<double>(seen.energy.work);
    // a chart that is kept may be followed through a place where it has no rates, to anywhere
    if (!options_.charts.reframe && report_.near_singular_chart.empty())
      report_.near_singular_chart = form_.diagnose(t, y);
    return seen;
  }

  /// The choice of least |E lambda| where rows are redundant; beside a singular position it may not exist.
  VectorX<S> lambda_at(const S& t, const StateVector& y) {
    auto& solver = form_.solved(t, y);
    if (solver.factors().dependent_row_count() == 0) return solver.lambda();
    try {
      return solver.minimum_norm_lambda();
    } catch (const ModelError&) {
      return form_.solved(t, y).lambda();
    }
  }

  const S start_;
  const SimulationOptions& options_;
  SimulationObserver& observer_;
  const bool is_implicit_, projects_;
  std::unique_ptr<integrators::AnyMethod<S>> method_;
  ConstrainedEquations<F> form_;
  SimulationReport report_;
};

}  // namespace detail

template <Formulation F>
SimulationReport simulate_in(const Model<typename F::Scalar>& model, const SimulationOptions& options,
                             SimulationObserver& observer) {
  return detail::Simulation<F>(model, options, observer).run();
}

}  // namespace trivium
