#pragma once
/// Where each number of a state stands in the vector of an integrator, y = (q, v, work):
///
///   q     of every body r, then its orientation in the formulation's own numbers
///   v     of every body r', then the velocity whose derivative is the formulation's unknown
///   work  done on the mechanism [J], where any is done
///
/// Accelerations, displacements and generalised forces have the places of v.

#include <vector>

#include "formulations/equations_of_motion.hpp"

namespace trivium {

template <Formulation F>
class StateLayout {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  /// Numbers of a body in q and in v.
  static constexpr int positions = 3 + F::orientation_size, velocities = 3 + F::rotational_unknowns;
  using Velocity = Vector<S, velocities>;

  explicit StateLayout(int nb) : nb_(nb) {}

  int nb() const { return nb_; }
  int position_size() const { return positions * nb_; }
  int velocity_size() const { return velocities * nb_; }
  /// Of q and v: the place of the work.
  int motion_size() const { return (positions + velocities) * nb_; }

  // parts of y
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
  /// y as states of the bodies, in the charts that they have.
  void load(const StateVector& y, std::vector<BodyState<F>>& state) const {
    for (int b = 0; b < nb_; ++b) {
      state[b].r = y.template segment<3>(positions * b);
      state[b].r_dot = y.template segment<3>(positions * nb_ + velocities * b);
      state[b].q = F::from_orientation(state[b].chart, orientation(y, b), velocity(y, b));
    }
  }

  // parts of a vector that has the places of v
  static auto of(StateVector& v, int b) { return v.template segment<velocities>(velocities * b); }
  static Vector3<S> r_of(const StateVector& v, int b) { return v.template segment<3>(velocities * b); }
  static typename F::Unknown q_of(const StateVector& v, int b) {
    return v.template segment<F::rotational_unknowns>(velocities * b + 3);
  }

 private:
  int nb_;
};

}  // namespace trivium
