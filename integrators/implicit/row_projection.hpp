#pragma once
/// Projection of the end of a step onto its constraints, positions first and then velocities, for steps whose
/// stages meet them only within tolerances. The corrections use the factored Newton matrix: each is the
/// smallest motion that removes the violation, in the metric of M with the springs' resistance,
///
///   M x + Phi_q^T mu = 0,   Phi_q x = -Phi    and then    Phi_q x = -(Phi_q v - nu)

#include <limits>

#include "integrators/implicit/newton.hpp"

namespace trivium::integrators {

/// Repeats the corrections until the violation is rounding or no longer falls. If it no longer falls, up to
/// 1000 times the bound of rounding is accepted, the safety factor of newton.hpp.
template <HasNewtonMatrix System>
requires HasInternalRows<System>
class RowProjection {
 public:
  using S = typename System::Scalar;

  /// Projects y with the factors of a matrix at a nearby state. Throws an IntegrationError if a row cannot be
  /// met.
  void move(System& system, const typename System::Factors& factors, const S& t, StateVector<S>& y) {
    const int nv = system.velocity_size();
    auto v = y.segment(system.position_size(), nv);
    x_.setZero(nv);
    system.normalise_step(S(1), y, x_);
    meet(
        system, factors, t,
        [&] {
          system.evaluate(t, y, at_);
          return system.position_rows(at_, rows_);
        },
        [&] {
          from_ = y;
          system.displace(from_, x_, y);
          system.normalise_step(S(1), y, x_);
        });
    x_.setZero(nv);
    system.normalise_step_velocity(S(1), y, x_);
    v += x_;
    meet(
        system, factors, t,
        [&] {
          system.evaluate(t, y, at_);
          return system.velocity_rows(at_, rows_);
        },
        [&] { v += x_; });
  }

 private:
  template <class Measure, class Move>
  void meet(System& system, const typename System::Factors& factors, const S& t, const Measure& measure,
            const Move& move) {
    S before = std::numeric_limits<S>::max();
    Violation<S> now = measure();
    // The limit 50 is a safety limit: with the factors of a far state the violation falls slowly.
    for (int k = 0; k < 50 && now.relative > rounding<S>() && now.relative < before; ++k, now = measure()) {
      before = now.relative;
      x_.setZero(system.velocity_size());
      mu_.setZero(system.multipliers());
      no_force_.setZero(x_.size());
      rows_ = -rows_;
      system.solve(factors, at_, no_force_, rows_, x_, mu_);
      move();
    }
    if (!(now.relative <= 1000 * rounding<S>())) throw_not_converged(system, t, now);
  }

  typename System::Evaluation at_;
  StateVector<S> from_, no_force_, rows_, x_, mu_;
};

}  // namespace trivium::integrators
