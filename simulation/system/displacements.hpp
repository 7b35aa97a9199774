#pragma once
/// Steps between states as implicit methods take them. A displacement d has the places of v: r moves by its
/// own part of d, an orientation as the formulation says (Lie-group formulations by a rotation vector, the
/// others by addition). Formulations with an internal row (r-p: p . p = 1) get back onto the row here, by a
/// change of v' that is part of the step.

#include <vector>

#include "simulation/system/state_layout.hpp"

namespace trivium {

template <Formulation F>
class Displacements {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  using Layout = StateLayout<F>;

  /// In the charts that the bodies' states have. Both must outlive this.
  Displacements(const Layout& layout, const std::vector<BodyState<F>>& state)
      : layout_(layout), state_(state) {}

  /// y's positions, step from those of `from` as far as by velocities in one unit of time.
  void displace(const StateVector& from, const StateVector& displacement, StateVector& y) const {
    for (int b = 0; b < nb(); ++b)
      layout_.place(y, b) << r_at(from, b) + Layout::r_of(displacement, b),
          F::step(state_[b].chart, layout_.orientation(from, b), Layout::q_of(displacement, b));
  }
  /// The displacement from one to another.
  void displacement(const StateVector& from, const StateVector& to, StateVector& displacement) const {
    displacement.resize(layout_.velocity_size());
    for (int b = 0; b < nb(); ++b)
      Layout::of(displacement, b) << r_at(to, b) - r_at(from, b),
          F::displacement(state_[b].chart, layout_.orientation(from, b), layout_.orientation(to, b));
  }
  /// How a displacement from a fixed place grows where the bodies move with v.
  void displacement_rate(const StateVector& displacement, const StateVector& v, StateVector& rate) const {
    rate.resize(layout_.velocity_size());
    for (int b = 0; b < nb(); ++b)
      Layout::of(rate, b) << Layout::r_of(v, b),
          F::displacement_rate(Layout::q_of(displacement, b), Layout::q_of(v, b));
  }
  /// How the numbers of y's positions grow where the bodies move with v.
  void position_rate(const StateVector& y, const StateVector& v, StateVector& rate) const {
    rate.resize(layout_.position_size());
    for (int b = 0; b < nb(); ++b)
      layout_.place(rate, b) << Layout::r_of(v, b),
          F::orientation_rate(state_[b].chart, layout_.orientation(y, b), Layout::q_of(v, b));
  }
  /// By displacements' numbers: a body's distance from the origin [m], and 1 for what turns it.
  void position_sizes(const StateVector& y, StateVector& sizes) const {
    sizes.setOnes(layout_.velocity_size());
    for (int b = 0; b < nb(); ++b) Layout::of(sizes, b).template head<3>().setConstant(r_at(y, b).norm());
  }
  /// Adds to v' what moves y, by `share` of it, onto the internal rows, and moves y's positions there.
  /// Returns whether there are any such rows.
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
  /// The same for their derivatives: adds to v' what moves v, by `share` of it.
  void normalise_step_velocity(const S& share, const StateVector& y, StateVector& v_dot) const {
    if constexpr (F::internal_constraints > 0)
      for (int b = 0; b < nb(); ++b) {
        typename F::Unknown change = Layout::q_of(v_dot, b);
        F::normalise_step_velocity(layout_.orientation(y, b), layout_.velocity(y, b), share, change);
        Layout::of(v_dot, b).tail(F::rotational_unknowns) = change;
      }
  }
  /// What v' leaves of the internal rows' second derivatives at these bodies, in the places of velocities
  /// behind the six of a body's reduced forces.
  void internal_residual(const std::vector<typename F::Reduced>& body, const StateVector& v_dot,
                         StateVector& left) const {
    if constexpr (F::internal_constraints > 0)
      for (int b = 0; b < nb(); ++b)
        Layout::of(left, b).template tail<F::internal_constraints>() =
            F::internal_gamma(body[b]) - F::internal_jacobian(body[b]) * Layout::q_of(v_dot, b);
  }
  /// Adds to x what removes that, by the least change of the unknowns.
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
};

}  // namespace trivium
