#pragma once
/// Jumps of velocities. Where a driver's function of time has a kink, its row asks for other velocities from
/// there on. Here it is decided whether they jump, and the impulse Lambda that the rows then give the bodies
/// is computed:
///
///   M dv + Phi_q^T Lambda = 0,   Phi_q dv = jump of nu
///
/// It does the work -Lambda . (nu before + nu after) / 2. FirstOrderEquations::pass_discontinuity asks here
/// and enters the impulse in its MotionLog (motion_log.hpp).

#include <optional>

#include "simulation/system/constraint_projection.hpp"
#include "simulation/system/energy_account.hpp"
#include "simulation/system/motion_log.hpp"

namespace trivium {

/// A jump of nu, beside the speeds of the bodies that rows connect, up to which it is rounding.
inline constexpr double smallest_jump = 1e-9;

/// Over a time t where functions may jump, from just before it: changes y's velocities and adds the work. The
/// bodies' states are y's. No impulse where velocities do not jump. Throws a ModelError.
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
