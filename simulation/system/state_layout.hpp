#pragma once
/// The order of the numbers in the state vector of an integrator, y = (q, v, work):
///
///     q     per body: r [m], then the orientation in the coordinates of the formulation
///     v     per body: r' [m/s], then the rotational velocity of the formulation, such as omega_bar or p'
///           (its time derivative is the rotational unknown of the equations of motion)
///     work  the work done on the mechanism [J]; absent if no driver or effect does any
///
/// Accelerations, displacements and generalised forces have the length and the order of v.

#include <vector>

#include "formulations/equations_of_motion.hpp"

namespace trivium {

/// Sizes and parts of y, and of vectors with the order of v, for nb bodies.
template <Formulation F>
class StateLayout {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  /// How many numbers a body has in q and in v.
  static constexpr int positions = 3 + F::orientation_size, velocities = 3 + F::rotational_unknowns;
  using Velocity = Vector<S, velocities>;

  explicit StateLayout(int nb) : nb_(nb) {}

  int nb() const { return nb_; }
  int position_size() const { return positions * nb_; }
  int velocity_size() const { return velocities * nb_; }
  /// The length of (q, v), which is also the index of the work.
  int motion_size() const { return (positions + velocities) * nb_; }

  // parts of y: position (r, orientation), rate (r', velocity), orientation and velocity of body b
  auto place(StateVector& y, int b) const { return y.template segment<positions>(positions * b); }
  auto rate(StateVector& y, int b) const {
    return y.template segment<velocities>(positions * nb_ + velocities * b);
  }
  typename F::Orientation orientation(const StateVector& y, int b) const {
    return y.template segment<F::orientation_size>(positions * b + 3);
  }
  typename F::Unknown velocity(const StateVector& y, int b) const {
    return y.template segment<F::rotational_unknowns>(positions * nb_ + velocities * b + 3);
  }
  /// Writes y into the body states; their charts stay as they are.
  void load(const StateVector& y, std::vector<BodyState<F>>& state) const {
    for (int b = 0; b < nb_; ++b) {
      state[b].r = y.template segment<3>(positions * b);
      state[b].r_dot = y.template segment<3>(positions * nb_ + velocities * b);
      state[b].q = F::from_orientation(state[b].chart, orientation(y, b), velocity(y, b));
    }
  }

  // parts of a vector with the order of v: all of body b, its translation, its rotation
  static auto of(StateVector& v, int b) { return v.template segment<velocities>(velocities * b); }
  static Vector3<S> r_of(const StateVector& v, int b) { return v.template segment<3>(velocities * b); }
  static typename F::Unknown q_of(const StateVector& v, int b) {
    return v.template segment<F::rotational_unknowns>(velocities * b + 3);
  }

 private:
  int nb_;
};

}  // namespace trivium
