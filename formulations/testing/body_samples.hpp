#pragma once
/// Test states of one body for the laws of the Formulation concept: random poses and velocities, in charts
/// of every sequence. Support for tests.

#include "bodies/rotations/so3.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/moving_body.hpp"

namespace trivium::test {

template <class F>
struct Sample {
  using S = typename F::Scalar;
  typename F::Chart chart;
  Vector4<S> p;
  Vector3<S> omega_bar, omega_bar_dot, a_bar;
  Matrix3<S> J_bar;
  typename F::Coordinates q;
  typename F::Kinematics body;
};

/// The rotational unknown for a given omega_bar', through the reduced unknowns x: A omega_bar' =
/// axes x + drift.
template <class F>
typename F::Unknown unknown_of(const typename F::Kinematics& body,
                               const Vector3<typename F::Scalar>& omega_bar_dot) {
  using S = typename F::Scalar;
  const AngularMotion<S> motion = F::angular_motion(typename F::Reduced{body});
  const Matrix3<S> axes = transposed<S>(motion.axes_T).template topRows<3>();
  const Vector3<S> omega_dot = body.A * omega_bar_dot;
  return F::from_reduced(body, axes.inverse() * (omega_dot - unpadded<S>(motion.drift)));
}

/// Applies a law to random poses and velocities, over all Euler sequences.
template <class F, class Law>
void for_all_samples(const Law& law) {
  using S = typename F::Scalar;
  Random random(51);
  for (const auto name : euler_sequence_names)
    for (int n = 0; n < 8; ++n) {
      Sample<F> s;
      s.p = random.euler_parameters<S>();
      s.chart = F::choose_chart({*parse_euler_sequence(name), true}, s.p);
      s.omega_bar = random.vector<S, 3>();
      s.omega_bar_dot = random.vector<S, 3>();
      s.a_bar = random.vector<S, 3>();
      const Matrix3<S> axes = rotation_matrix(random.euler_parameters<S>());
      s.J_bar = axes * Vector3<S>(S(1), S(random.uniform(1, 2)), S(2)).asDiagonal() * axes.transpose();
      s.q = F::from_pose(s.chart, s.p, s.omega_bar);
      const Vector3<S> r = random.vector<S, 3>(), r_dot = random.vector<S, 3>();
      s.body = F::kinematics(s.chart, r, r_dot, s.q);
      law(s);
    }
}

}  // namespace trivium::test
