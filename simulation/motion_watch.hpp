#pragma once
/// What a run tells of its motion. `watch` looks at every state that the motion reaches: drift off the
/// constraints and energy, for the report. `show` looks at every output: also lambda and the joint reactions,
/// for the observer.
///
/// Where rows are dependent, lambda is the choice of least |E lambda|. Where that choice does not exist, as
/// beside a singular position, lambda is that of the solver.

#include <cmath>
#include <limits>

#include "base/raise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/joint_reaction.hpp"
#include "integrators/contract/any_method.hpp"
#include "simulation/simulate.hpp"
#include "simulation/system/constrained_equations.hpp"

namespace trivium {

template <Formulation F>
class MotionWatch {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  /// From the start of the equations, whose energy is what later ones are compared with. All must outlive
  /// this.
  MotionWatch(ConstrainedEquations<F>& equations, const integrators::AnyMethod<S>& method,
              const SimulationOptions& options, SimulationObserver& observer, SimulationReport& report,
              const S& t)
      : equations_(equations),
        method_(method),
        options_(options),
        observer_(observer),
        report_(report),
        at_start_(first_order().energy(t, equations.start())) {
    report_.does_work = first_order().does_work();
    report_.energy_start = static_cast<double>(at_start_.total());
  }

  /// What a state's report and sample both say.
  struct Seen {
    MotionEnergy<S> energy;
    double phi, phi_dot;
  };

  /// What the report says of every state.
  Seen watch(const S& t, const StateVector& y) {
    const Seen seen{first_order().energy(t, y),
                    static_cast<double>(first_order().position_violation(t, y).size),
                    static_cast<double>(first_order().velocity_violation(t, y).size)};
    raise(report_.normalisation, static_cast<double>(first_order().normalisation_violation(y)));
    raise(report_.phi, seen.phi);
    raise(report_.phi_dot, seen.phi_dot);
    raise(report_.unaccounted_energy, static_cast<double>(unaccounted_energy(seen.energy, at_start_)));
    raise(report_.largest_kinetic, static_cast<double>(seen.energy.kinetic));
    report_.energy_end = static_cast<double>(seen.energy.total());
    report_.work = static_cast<double>(seen.energy.work);
    // a chart that is kept may be followed through a place where it has no rates, to anywhere
    if (!options_.charts.reframe && report_.near_singular_chart.empty())
      report_.near_singular_chart = first_order().diagnose(t, y);
    return seen;
  }

  /// A sample with all that there is to say of a state.
  bool show(const S& t, const StateVector& y) {
    const Seen seen = watch(t, y);
    MotionSample sample;
    sample.energy = static_cast<double>(seen.energy.total());
    sample.phi = seen.phi;
    sample.phi_dot = seen.phi_dot;
    sample.charts = first_order().charts();
    sample.angles = first_order().counted_angles();
    AccelerationSolver<F>& solver = first_order().solved(t, y);
    for (int b = 0; b < first_order().nb(); ++b) {
      sample.r_ddot.push_back(scalar_cast<double>(solver.r_ddot(b)));
      sample.omega_bar_dot.push_back(scalar_cast<double>(solver.omega_bar_dot(b)));
    }
    sample.lambda_error = solver.corrections().lambda;
    sample.acceleration_error = solver.corrections().acceleration;
    sample.lambda_unique = solver.factors().dependent_row_count() == 0
                               ? std::vector<bool>(solver.mechanism().nc(), true)
                               : solver.unique();
    const VectorX<S> lambda = lambda_at(t, y);
    sample.lambda = scalar_cast<double>(lambda);
    sample.lambda_rest = rest_of(lambda);
    if (const VectorX<S>* raw = method_.lambda()) {
      sample.raw_lambda = scalar_cast<double>(*raw);
      sample.raw_lambda_rest = rest_of(*raw);
      const VectorX<S> apart = *raw - first_order().solved(t, y).lambda();
      raise(report_.lambda_gap, static_cast<double>(largest_magnitude(apart)));
    }
    const auto equations = equations_of_motion<F>(first_order().mechanism(), first_order().state(), t);
    for (const Joint<S>& joint : first_order().mechanism().joints) {
      const Reaction<S> r =
          joint_reaction(equations, joint, lambda, End::j).about(joint_point(equations, joint));
      sample.reactions.push_back(
          {scalar_cast<double>(r.force), scalar_cast<double>(r.torque), scalar_cast<double>(r.point)});
    }
    sample.state = state_at(t, y);
    if constexpr (is_beyond_double)
      sample.state_rest =
          in_double(first_order().to_mechanism_state(t, y), [](const auto& x) { return rest_of(x); });
    return observer_.sample(sample);
  }

  /// A sample of the state alone.
  bool show_state(const S& t, const StateVector& y) {
    MotionSample sample;
    sample.state = state_at(t, y);
    return observer_.sample(sample);
  }

  /// Where the run stands, for another to go on from.
  RunEnd end(const S& start, const S& t, const StateVector& y) {
    RunEnd end{state_at(t, y), {}, first_order().save(y)};
    end.run.t = static_cast<double>(t);
    end.run.start = static_cast<double>(start);
    end.run.phi = static_cast<double>(first_order().position_violation(t, y).size);
    end.run.phi_dot = static_cast<double>(first_order().velocity_violation(t, y).size);
    for (const double theta : first_order().joint_angles(t, y))
      end.turns.push_back(JointAngle<S>::turns_of(theta));
    return end;
  }

 private:
  FirstOrderEquations<F>& first_order() { return equations_.first_order(); }

  MechanismState<double> state_at(const S& t, const StateVector& y) {
    return in_double(first_order().to_mechanism_state(t, y),
                     [](const auto& x) { return scalar_cast<double>(x); });
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

  /// The choice of least |E lambda| where rows are dependent; beside a singular position it may not exist.
  VectorX<S> lambda_at(const S& t, const StateVector& y) {
    auto& solver = first_order().solved(t, y);
    if (solver.factors().dependent_row_count() == 0) return solver.lambda();
    try {
      return solver.minimum_norm_lambda();
    } catch (const ModelError&) {
      return first_order().solved(t, y).lambda();
    }
  }

  ConstrainedEquations<F>& equations_;
  const integrators::AnyMethod<S>& method_;
  const SimulationOptions& options_;
  SimulationObserver& observer_;
  SimulationReport& report_;
  const MotionEnergy<S> at_start_;
};

}  // namespace trivium
