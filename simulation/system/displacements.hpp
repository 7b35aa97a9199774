#pragma once
/// Displacements between states, for implicit methods. This file also changes v' such that internal rows,
/// such as p . p = 1 in r-p, hold within a step.

#include <algorithm>
#include <utility>
#include <vector>

#include "simulation/system/state_layout.hpp"

namespace trivium {

/// Moves states by displacements, and finds the displacement between two states. A displacement d has as many
/// numbers as v, in the same order. The position r moves by addition, the orientation as the formulation
/// defines: by a rotation vector in Lie-group formulations, by addition in the others.
template <Formulation F>
class Displacements {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  using Layout = StateLayout<F>;

  /// Charts are those of the body states; `reach` of each body: how far its points move by a rotation of 1
  /// rad [m]. The first two arguments must outlive this object.
  Displacements(const Layout& layout, const std::vector<BodyState<F>>& state, std::vector<S> reach)
      : layout_(layout), state_(state), reach_(std::move(reach)) {}

  /// Sets the positions of y to those of `from`, moved by the displacement. A displacement equals the motion
  /// with the constant velocity v = d during one unit of time.
  void displace(const StateVector& from, const StateVector& displacement, StateVector& y) const {
    for (int b = 0; b < nb(); ++b)
      layout_.place(y, b) << r_at(from, b) + Layout::r_of(displacement, b),
          F::step(state_[b].chart, layout_.orientation(from, b), Layout::q_of(displacement, b));
  }
  /// The displacement that leads from the positions of `from` to those of `to`; inverse of `displace`.
  void displacement(const StateVector& from, const StateVector& to, StateVector& displacement) const {
    displacement.resize(layout_.velocity_size());
    for (int b = 0; b < nb(); ++b)
      Layout::of(displacement, b) << r_at(to, b) - r_at(from, b),
          F::displacement(state_[b].chart, layout_.orientation(from, b), layout_.orientation(to, b));
  }
  /// The time derivative of the displacement from a fixed state while the bodies move with v.
  void displacement_rate(const StateVector& displacement, const StateVector& v, StateVector& rate) const {
    rate.resize(layout_.velocity_size());
    for (int b = 0; b < nb(); ++b)
      Layout::of(rate, b) << Layout::r_of(v, b),
          F::displacement_rate(Layout::q_of(displacement, b), Layout::q_of(v, b));
  }
  /// The time derivative of the positions in y (r and orientation) while the bodies move with v.
  void position_rate(const StateVector& y, const StateVector& v, StateVector& rate) const {
    rate.resize(layout_.position_size());
    for (int b = 0; b < nb(); ++b)
      layout_.place(rate, b) << Layout::r_of(v, b),
          F::orientation_rate(state_[b].chart, layout_.orientation(y, b), Layout::q_of(v, b));
  }
  /// Sizes for tolerances, per number of a displacement: 1 for rotations; for translations of a body |r| [m],
  /// or how far its points move by a rotation of 1 rad, if this is larger.
  void position_sizes(const StateVector& y, StateVector& sizes) const {
    sizes.setOnes(layout_.velocity_size());
    for (int b = 0; b < nb(); ++b)
      Layout::of(sizes, b).template head<3>().setConstant(std::max(S(r_at(y, b).norm()), reach_[b]));
  }
  /// Moves the positions of y onto the internal rows, and changes v' accordingly: q moves by `share` = dq/dv'
  /// times the change of v'. Returns whether the formulation has internal rows.
  bool normalise_step(const S& share, StateVector& y, StateVector& v_dot) const {
    if constexpr (F::internal_constraints == 0) {
      return false;
    } else {
      for (int b = 0; b < nb(); ++b) {
        typename F::Orientation x = layout_.orientation(y, b);
        typename F::Unknown change = Layout::q_of(v_dot, b);
        F::normalise_step(x, share, change);
        layout_.place(y, b).tail(F::orientation_size) = x;
        Layout::of(v_dot, b).tail(F::rotational_unknowns) = change;
      }
      return true;
    }
  }
  /// The same for the first derivatives of the internal rows: changes v' such that v, which moves by `share`
  /// = dv/dv' times the change, satisfies them.
  void normalise_step_velocity(const S& share, const StateVector& y, StateVector& v_dot) const {
    if constexpr (F::internal_constraints > 0)
      for (int b = 0; b < nb(); ++b) {
        typename F::Unknown change = Layout::q_of(v_dot, b);
        F::normalise_step_velocity(layout_.orientation(y, b), layout_.velocity(y, b), share, change);
        Layout::of(v_dot, b).tail(F::rotational_unknowns) = change;
      }
  }
  /// The residual gamma - P x of the second derivatives of the internal rows, where P is their Jacobian and x
  /// the rotational part of v'. In `left`, a body's residual stands after its six reduced forces.
  void internal_residual(const std::vector<typename F::Reduced>& body, const StateVector& v_dot,
                         StateVector& left) const {
    if constexpr (F::internal_constraints > 0)
      for (int b = 0; b < nb(); ++b)
        Layout::of(left, b).template tail<F::internal_constraints>() =
            F::internal_gamma(body[b]) - F::internal_jacobian(body[b]) * Layout::q_of(v_dot, b);
  }
  /// Adds to x the least change of the rotational unknowns that makes the residual of the internal rows zero.
  void solve_internal_rows(const std::vector<typename F::Reduced>& body, const StateVector& left,
                           StateVector& x) const {
    if constexpr (F::internal_constraints > 0)
      for (int b = 0; b < nb(); ++b) {
        const auto P = F::internal_jacobian(body[b]);
        const auto rows = left.template segment<F::internal_constraints>(Layout::velocities * b + 6);
        Layout::of(x, b).template tail<F::rotational_unknowns>() +=
            P.transpose() * rows.cwiseQuotient(P.rowwise().squaredNorm());
      }
  }

 private:
  int nb() const { return layout_.nb(); }
  auto r_at(const StateVector& y, int b) const { return y.template segment<3>(Layout::positions * b); }

  const Layout& layout_;
  const std::vector<BodyState<F>>& state_;
  const std::vector<S> reach_;
};

}  // namespace trivium
