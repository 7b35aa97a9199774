#pragma once
/// What integrators ask of a model: concepts, and nothing of formulations or scenes.

#include <Eigen/Core>
#include <concepts>
#include <limits>
#include <string>

#include "base/error.hpp"

namespace trivium::integrators {

template <class S>
using StateVector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

/// y' = f(t, y), y on the manifold that constraints leave.
///
/// `derivative` may throw a std::runtime_error where y makes no sense; a method then takes a smaller step.
/// A violation is the largest distance from a constraint, in units of the model; `relative_violation` is the
/// one measured last beside the model's own numbers, so that rounding is some u. `correct_...` is one step of
/// the way back from there, by a matrix factored there or, unless `factor`, before. `projection_is_too_large`
/// is asked whether a projection went too far to be one, `longest_step` how long a step from a state may be
/// for reasons of the model. `accept_state` is told every state that the motion has reached, projected; it
/// returns whether y is in other coordinates since, so that what a method remembers of it is void.
/// `pass_discontinuity` goes over a time where the model may jump, from just before it; it returns whether y
/// jumped.
template <class System>
concept FirstOrderSystem = requires(System& system, const typename System::Scalar& t,
                                    const StateVector<typename System::Scalar>& y,
                                    StateVector<typename System::Scalar>& changed, int index, bool factor) {
  { system.size() } -> std::convertible_to<int>;
  { system.start() } -> std::convertible_to<StateVector<typename System::Scalar>>;
  system.derivative(t, y, changed);
  { system.position_violation(t, y) } -> std::convertible_to<typename System::Scalar>;
  { system.velocity_violation(t, y) } -> std::convertible_to<typename System::Scalar>;
  { system.relative_violation() } -> std::convertible_to<typename System::Scalar>;
  { system.projection_is_too_large(y, y, y) } -> std::same_as<bool>;
  { system.longest_step(t, y) } -> std::convertible_to<typename System::Scalar>;
  system.correct_positions(changed, factor);
  system.correct_velocities(changed, factor);
  system.normalise(changed);
  { system.worst_row() } -> std::convertible_to<std::string>;
  { system.accept_state(t, changed) } -> std::same_as<bool>;
  { system.pass_discontinuity(t, t, changed) } -> std::same_as<bool>;
  { system.diagnose(t, y) } -> std::convertible_to<std::string>;
};

/// M(q) v' + Phi_q^T lambda = Q(q, v, t), Phi(q, t) = 0 beside the same as y' = f(t, y): y begins with q and
/// v, and what follows grows by `work_rate`. Implicit methods see q move by displacements, which are of v's
/// kind: `displace` sets y's positions to where one leads from another's, `displacement` is the way between
/// two, `displacement_rate` how one grows with v, `position_rate` how y's own numbers of positions do;
/// `position_sizes` how large, number by number of a displacement, what it moves is: errors relative to it
/// are. `normalise_step` is for rows that a model keeps to itself, met by a change of v' that moves q by
/// `share` of it; it returns whether there are any.
///
/// `normalise_step_velocity` is the same for their derivatives.
///
/// A step's equations have v' and lambda as unknowns, and q and v move with v' by a position and a velocity
/// share. `residual` evaluates force + Phi_q^T lambda - Q, where the force stands for M v', and Phi: it
/// returns the largest imbalance beside the forces at work, `relative_row_violation` that of Phi beside the
/// model's numbers; both mean the same whatever coordinates a model uses. `velocity_rows` puts Phi' in the
/// place of Phi, `position_rows` evaluates Phi alone. `factor` makes Newton's matrix of what was balanced
/// last (that of M alone for shares of 0). By the matrix at hand `newton` adds what removes imbalance and
/// rows to v' and lambda, `project` the least change that removes Phi less a share of Phi',
/// `velocity_projection` what a force and the rows ask for.
///
/// Methods of several stages `select` one of several evaluations and matrices that are kept side by side;
/// they take what was evaluated at each (`row_residual`, `force_residual`; `take_force` makes the same of a
/// force of v's kind) and `solve` for a mixture: M x + Phi_q^T mu = left, Phi_q x = rows, where springs
/// resist what x stretches them by beyond a slack; `solve_force` for a force of v's kind. Libraries that have
/// no `normalise_step` meet the second derivatives of internal rows: `take_internal_rows` puts what v' leaves
/// of them beside an imbalance, `solve_internal_rows` adds to x what removes it. `has_springs` says whether
/// the matrix depends on the shares, `spring_constants` by what stiffness and damping.
template <class System>
concept ConstrainedSystem = FirstOrderSystem<System> &&
    requires(System& system, const typename System::Scalar& t, const StateVector<typename System::Scalar>& y,
             const StateVector<typename System::Scalar>& v, StateVector<typename System::Scalar>& changed,
             StateVector<typename System::Scalar>& lambda, int index) {
  { system.position_size() } -> std::convertible_to<int>;
  { system.velocity_size() } -> std::convertible_to<int>;
  { system.multipliers() } -> std::convertible_to<int>;
  system.accelerations(t, y, changed, lambda);
  system.displace(y, v, changed);
  system.displacement(y, y, changed);
  system.displacement_rate(v, v, changed);
  system.position_rate(y, v, changed);
  system.position_sizes(y, changed);
  { system.normalise_step(t, changed, lambda) } -> std::same_as<bool>;
  system.normalise_step_velocity(t, y, changed);
  { system.inertia_is_constant() } -> std::same_as<bool>;
  system.inertia_force(y, v, changed);
  system.applied_force(t, y, changed);
  { system.residual(t, y, v, v) } -> std::convertible_to<typename System::Scalar>;
  { system.position_rows(t, y) } -> std::convertible_to<typename System::Scalar>;
  { system.velocity_rows() } -> std::convertible_to<typename System::Scalar>;
  { system.relative_row_violation() } -> std::convertible_to<typename System::Scalar>;
  { system.least_met_row() } -> std::convertible_to<std::string>;
  system.select(index);
  system.factor(t, t);
  system.newton(t, changed, lambda);
  system.project(t, changed);
  system.velocity_projection(v, changed, lambda);
  system.row_residual(changed);
  system.force_residual(changed);
  system.take_force(v, changed);
  system.solve(v, v, changed, lambda);
  system.solve(v, v, v, changed, lambda, changed);
  system.solve_force(v, changed, lambda);
  system.take_internal_rows(v, changed);
  system.solve_internal_rows(y, v, changed);
  { system.has_springs() } -> std::same_as<bool>;
  system.spring_constants(changed, lambda);
  { system.work_rate(v) } -> std::convertible_to<typename System::Scalar>;
};

/// A method gave up: says at what time, why, and what to try.
class IntegrationError : public Error {
 public:
  explicit IntegrationError(const std::string& what, ErrorKind kind = ErrorKind::integration)
      : Error(kind, what) {}
};

/// What was asked for cannot be: times that do not fit together, a method with steps that it does not take.
class UsageError : public IntegrationError {
 public:
  explicit UsageError(const std::string& what) : IntegrationError(what, ErrorKind::input) {}
};

/// What rounding may leave of a measure beside the model's own numbers.
template <class S>
S rounding() {
  return S(16 * std::numeric_limits<S>::epsilon());
}

/// What a method may miss: errors of each number up to atol + rtol |number|, per step.
struct Tolerances {
  double rtol = 1e-8, atol = 1e-10;
};

/// What a method has done.
struct Counters {
  long steps = 0, rejected_steps = 0, right_sides = 0, restarts = 0;
  long iterations = 0;  ///< of Newton's method
};

}  // namespace trivium::integrators
