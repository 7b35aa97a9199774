#pragma once
/// The one definition behind the simulations in each formulation and Scalar.

#include <algorithm>
#include <cmath>

#include "integrators/methods.hpp"
#include "validation/simulation.hpp"

namespace trivium {

namespace detail {

template <Formulation F>
class Simulation {
 public:
  using S = typename F::Scalar;
  using Flat = VectorX<S>;

  Simulation(const scenes::Scene& scene, const SimulationOptions& options, SimulationObserver& observer)
      : options_(options),
        observer_(observer),
        form_(make_mechanism<S>(scene), make_state<S>(scene, S(options.start)),
              {options.charts, options.baumgarte, options.projects}) {}

  SimulationReport run() {
    using namespace integrators;
    const TimeGrid grid(options_.start, options_.end, options_.output_step, options_.step,
                        form_.mechanism().kinks());
    const auto method = make_method<S>(options_.integrator, options_.step ? Steps::given : Steps::chosen,
                                       options_.tolerances);
    Erased<FirstOrderForm<F>> system(form_);
    ProjectionReport<S> projection;
    const MotionEnergy<S> at_start = form_.energy(S(options_.start), form_.start());
    report_.is_projected = options_.projects;
    report_.does_work = form_.does_work();
    report_.energy_start = static_cast<double>(S(at_start.kinetic + at_start.potential));
    const auto finish = [&] {
      report_.counters = method->counters();
      report_.factorisations = form_.factorisations();
      report_.reframings = form_.reframings();
      report_.passages = form_.passages();
      report_.projection = {static_cast<double>(projection.position),
                            static_cast<double>(projection.velocity),
                            static_cast<double>(projection.position_left),
                            static_cast<double>(projection.velocity_left), projection.changes};
    };
    report_.complete = integrate<AnySystem<S>, AnyMethod<S>>(
        system, *method, grid, options_.projects, projection,
        [&](const S& t, const Flat& y) {
          report_.normalisation =
              std::max(report_.normalisation, static_cast<double>(form_.normalisation_violation(y)));
          report_.reached = static_cast<double>(t);
          watch(t, y, at_start);
          return observer_.step(report_.reached) ? Continue::yes : Continue::no;
        },
        [&](const S& t, const Flat& y) { show(t, y, at_start); });
    finish();
    return report_;
  }

 private:
  void show(const S& t, const Flat& y, const MotionEnergy<S>& at_start) {
    MotionSample sample;
    const MotionEnergy<S> energy = form_.energy(t, y);
    sample.energy = static_cast<double>(S(energy.kinetic + energy.potential));
    sample.phi = static_cast<double>(form_.position_violation(t, y));
    sample.phi_dot = static_cast<double>(form_.velocity_violation(t, y));
    const VectorX<S> lambda = lambda_at(t, y);
    sample.lambda = scalar_cast<double>(lambda);
    const auto equations = equations_of_motion<F>(form_.mechanism(), form_.state(), t);
    for (const Joint<S>& joint : form_.mechanism().joints) {
      const Reaction<S> r =
          joint_reaction(equations, joint, lambda, End::j).about(joint_point(equations, joint));
      sample.reactions.push_back(
          {scalar_cast<double>(r.force), scalar_cast<double>(r.torque), scalar_cast<double>(r.point)});
    }
    const MechanismState<S> state = form_.physical(t, y);
    sample.state.t = static_cast<double>(t);
    for (const Pose<S>& pose : state.pose)
      sample.state.pose.push_back({scalar_cast<double>(pose.r), scalar_cast<double>(pose.p)});
    for (const Twist<S>& twist : state.twist)
      sample.state.twist.push_back({scalar_cast<double>(twist.r_dot), scalar_cast<double>(twist.omega_bar)});
    report_.energy_end = sample.energy;
    watch(t, y, at_start);
    observer_.sample(sample);
  }

  /// What the report says of every state.
  void watch(const S& t, const Flat& y, const MotionEnergy<S>& at_start) {
    const MotionEnergy<S> energy = form_.energy(t, y);
    const auto raise = [](double& largest, const S& value) {
      const double now = static_cast<double>(value);
      if (!(now <= largest)) largest = now;
    };
    using std::abs;
    raise(report_.phi, form_.position_violation(t, y));
    raise(report_.phi_dot, form_.velocity_violation(t, y));
    raise(report_.balance, S(abs(energy.total() - at_start.total() - energy.work)));
    raise(report_.largest_kinetic, energy.kinetic);
    report_.work = static_cast<double>(energy.work);
  }

  /// The choice of least |E lambda| where rows are redundant; beside a singular position it may not exist.
  VectorX<S> lambda_at(const S& t, const Flat& y) {
    auto& solver = form_.solved(t, y);
    if (solver.factors().left_out() == 0) return solver.lambda();
    try {
      return solver.minimum_norm_lambda();
    } catch (const ModelError&) {
      return form_.solved(t, y).lambda();
    }
  }

  const SimulationOptions& options_;
  SimulationObserver& observer_;
  FirstOrderForm<F> form_;
  SimulationReport report_;
};

}  // namespace detail

template <Formulation F>
SimulationReport simulate_in(const scenes::Scene& scene, const SimulationOptions& options,
                             SimulationObserver& observer) {
  return detail::Simulation<F>(scene, options, observer).run();
}

}  // namespace trivium
