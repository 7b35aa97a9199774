#pragma once
/// Jumps of velocities. At a kink of a driver's function of time the right side nu of its row can jump, and
/// the velocities then jump with it. The function below decides whether they jump, and computes the change of
/// velocities dv and the impulse Lambda of the rows:
///
///     M dv + Phi_q^T Lambda = 0,   Phi_q dv = jump of nu
///
/// The impulse does the work -Lambda . (nu before + nu after) / 2. FirstOrderEquations::pass_discontinuity
/// calls the function and enters the impulse in its MotionLog (motion_log.hpp).

#include <optional>

#include "simulation/system/constraint_projection.hpp"
#include "simulation/system/energy_account.hpp"
#include "simulation/system/motion_log.hpp"

namespace trivium {

/// The jump of nu, relative to the speeds of the row's component, up to which a jump counts as rounding.
/// `before` and t differ by a few epsilons; where there is no jump, nu differs by rounding only, which is far
/// below this value.
inline constexpr double smallest_jump = 1e-9;

/// Passes the time t, where functions of time may have a kink; `before` is a time just before t. Changes the
/// velocities of y and adds the work of the impulse. `state` must be the state of y. Returns no impulse if
/// the velocities do not jump. Throws a ModelError if the matrix is singular.
template <Formulation F>
std::optional<Impulse<typename F::Scalar>> pass_discontinuity(
    const StateLayout<F>& layout, const std::vector<BodyState<F>>& state, AccelerationSolver<F>& solver,
    ConstraintProjection<F>& projection,
    const EnergyAccount<typename F::Scalar, MechanismTypesOf<F>>& account, const typename F::Scalar& before,
    const typename F::Scalar& t, VectorX<typename F::Scalar>& y) {
  using S = typename F::Scalar;
  projection.move(state, t);
  if (!(projection.measure_jump(before).relative > S(smallest_jump))) return {};
  projection.correct_velocities(layout, state, y, true);
  Impulse<S> impulse{static_cast<double>(t), VectorX<S>(solver.mechanism().nc())};
  projection.copy_multipliers(impulse.lambda);
  const auto& body = solver.assembly().body();
  y[layout.motion_size()] +=
      (account.drivers_power(body, impulse.lambda, before) + account.drivers_power(body, impulse.lambda, t)) /
      2;
  return impulse;
}

}  // namespace trivium
