#pragma once
/// Observation of a run, for its report and its observer.
///
/// If rows are dependent, lambda is the one with the least |E lambda|. Such a lambda does not exist if an
/// inertia is singular, and may not exist near a singular position. The lambda of the acceleration solver is
/// taken then, which is 0 in dependent rows.

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/consistency.hpp"
#include "formulations/joint_reaction.hpp"
#include "integrators/contract/any_method.hpp"
#include "integrators/contract/errors.hpp"
#include "mechanism/mechanism_cast.hpp"
#include "simulation/simulate.hpp"
#include "simulation/step_errors.hpp"
#include "simulation/system/constrained_equations.hpp"

namespace trivium {

/// Follows one run. `watch` is called at every accepted state and enters constraint violations and energy
/// into the report. `show` is called at every output: it does the same as `watch`, computes lambda and the
/// joint reactions, and passes a sample to the observer. `show` throws an IntegrationError if the motion has
/// changed to another branch, which is decided in double.
template <Formulation F>
class MotionWatch {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  /// This run begins at time t. Energies and work in the report count from there: in a run that continues an
  /// earlier one, y contains the work of the earlier run, which is subtracted. `step_errors` is absent if
  /// errors of single steps are not estimated. All other arguments must outlive this object.
  MotionWatch(ConstrainedEquations<F>& equations, const integrators::AnyMethod<S>& method,
              const SimulationOptions& options, SimulationObserver& observer, SimulationReport& report,
              const S& t, std::optional<StepErrors<F>> step_errors)
      : equations_(equations),
        method_(method),
        options_(options),
        observer_(observer),
        report_(report),
        at_start_(first_order().energy(t, equations.start())),
        step_errors_(std::move(step_errors)) {
    report_.does_work = first_order().does_work();
    report_.energy_start = static_cast<double>(at_start_.total());
  }

  /// The values of a state that both the report and a sample contain.
  struct Seen {
    MotionEnergy<S> energy;
    double phi, phi_dot;
  };

  /// Enters an accepted state into the report.
  Seen watch(const S& t, const StateVector& y) {
    MotionEnergy<S> energy = first_order().energy(t, y);
    const S phi = first_order().position_violation(t, y).size;
    const integrators::Violation<S> phi_dot = first_order().velocity_violation(t, y);
    const Seen seen{std::move(energy), static_cast<double>(phi), static_cast<double>(phi_dot.size)};
    raise(report_.normalisation, static_cast<double>(first_order().normalisation_violation(y)));
    raise(report_.phi, seen.phi);
    raise(report_.phi_dot, seen.phi_dot);
    raise(report_.unaccounted_energy, static_cast<double>(unaccounted_energy(seen.energy, at_start_)));
    raise(report_.largest_kinetic, static_cast<double>(seen.energy.kinetic));
    report_.energy_end = static_cast<double>(seen.energy.total());
    if (step_errors_) step_errors_->step(t, y, phi_dot);
    report_.work = static_cast<double>(S(seen.energy.work - at_start_.work));
    // with kept charts, a step across a singularity can end in a wrong state without an error
    if (!options_.charts.reframe && report_.near_singular_chart.empty())
      report_.near_singular_chart = first_order().near_singular_chart(t, y);
    return seen;
  }

  /// Passes a complete sample of a state to the observer. Returns whether to go on.
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
    require_finite(t, y, sample);
    require_branches(sample.state);
    if constexpr (is_beyond_double)
      sample.state_rest =
          in_double(first_order().to_mechanism_state(t, y), [](const auto& x) { return rest_of(x); });
    return observer_.sample(sample);
  }

  /// Passes a sample with poses and twists alone, for runs that are timed. Returns whether to go on.
  bool show_state(const S& t, const StateVector& y) {
    MotionSample sample;
    sample.state = state_at(t, y);
    return observer_.sample(sample);
  }

  /// The end of the run, from which another run can continue.
  RunEnd end(const S& start, const S& t, const StateVector& y) {
    report_.fastest_energy = static_cast<double>(first_order().fastest_energy());
    if (step_errors_) {
      report_.local_errors = step_errors_->sums();
      report_.errs_most = first_order().mechanism().body_names[report_.local_errors->body];
    }
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

  /// Throws an IntegrationError, with the effect that causes it, if accelerations or multipliers are not
  /// finite.
  void require_finite(const S& t, const StateVector& y, const MotionSample& sample) {
    bool is_finite = sample.lambda.allFinite();
    for (std::size_t b = 0; b < sample.r_ddot.size(); ++b)
      is_finite = is_finite && sample.r_ddot[b].allFinite() && sample.omega_bar_dot[b].allFinite();
    if (is_finite) return;
    const std::string cause = first_order().excessive_load(t, y);
    throw integrators::IntegrationError(
        Place{"", static_cast<double>(t)},
        cause.empty() ? "accelerations or multipliers are not finite; take smaller steps" : cause);
  }
  /// Long steps can lead to another branch, where the rows of a joint hold too, such as half a turn beside a
  /// driven angle. Throws an IntegrationError that names the joint; not if the motion began on such a branch.
  void require_branches(const MechanismState<double>& state) {
    const std::vector<std::string> wrong = wrong_branches(joints_in_double(), state);
    if (!has_shown_) began_on_another_branch_ = !wrong.empty();
    has_shown_ = true;
    if (!wrong.empty() && !began_on_another_branch_)
      throw integrators::IntegrationError(
          Place{"", state.t}, fmt::format("the motion has changed to another branch: {}; take tighter "
                                          "tolerances or smaller steps",
                                          wrong.front()));
  }
  const std::vector<Joint<double>>& joints_in_double() {
    if constexpr (std::is_same_v<S, double>) {
      return first_order().mechanism().joints;
    } else {
      if (joints_.empty()) joints_ = mechanism_cast<double>(first_order().mechanism()).joints;
      return joints_;
    }
  }

  MechanismState<double> state_at(const S& t, const StateVector& y) {
    return in_double(first_order().to_mechanism_state(t, y),
                     [](const auto& x) { return scalar_cast<double>(x); });
  }
  /// The state in double, each of its vectors converted by `part`.
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
  /// The rounding error of x in double; empty if S has no more digits than double.
  static VectorX<double> rest_of(const VectorX<S>& x) {
    if constexpr (is_beyond_double)
      return scalar_cast<double>(VectorX<S>(x - scalar_cast<S>(scalar_cast<double>(x))));
    else
      return {};
  }

  /// lambda at (t, y), chosen as the head of this file says.
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
  std::optional<StepErrors<F>> step_errors_;
  bool has_shown_ = false, began_on_another_branch_ = false;
  std::vector<Joint<double>> joints_;  ///< of the mechanism in double, if S is another Scalar
};

}  // namespace trivium
