#pragma once
/// Features: what a constraint sees instead of coordinates. A feature is a global vector that moves with its
/// bodies: a constant, a body vector a = A abar, or the point offset d_ij. In the coordinates of a
/// formulation it has a value, a rate, a Jacobian with respect to the accelerations' unknowns, and a bias
/// (its second derivative where the unknowns are zero). Every basic constraint is a dot product of two of
/// them.

#include "bodies/point_offset.hpp"
#include "constraints/body_kinematics.hpp"

namespace trivium {

/// How large a feature's value, rate, bias and gradients (by a body's place, and by turns of body i and j)
/// could be, by magnitudes alone, nothing cancelling.
template <class Scalar>
struct FeatureMagnitude {
  Scalar value{0}, rate{0}, bias{0}, r{0}, rot_i{0}, rot_j{0};
};

/// A vector fixed in the global frame.
template <class Scalar>
struct ConstantFeature {
  Vector3<Scalar> vector;

  const Vector3<Scalar>& value() const { return vector; }
  Scalar bias_along(const Vector3<Scalar>&) const { return Scalar(0); }
  Scalar drift_along(const Vector3<Scalar>&) const { return Scalar(0); }
  template <class Row>
  void add_jacobian(const Vector3<Scalar>&, Row&) const {}
  Vector3<Scalar> rate() const { return Vector3<Scalar>::Zero(); }
  template <class Acceleration>
  Vector3<Scalar> acceleration(const Acceleration&, const Acceleration&) const {
    return Vector3<Scalar>::Zero();
  }
  FeatureMagnitude<Scalar> magnitude() const { return {vector.norm()}; }
};

/// a = A abar on the body at one end.
template <BodyKinematics Body, End end>
struct BodyVectorFeature {
  using Scalar = typename Body::Scalar;
  const Body& body;
  BodyVector<Scalar> vector;

  /// The body must outlive this.
  BodyVectorFeature(const Body& of, const Vector3<Scalar>& a_bar) : body(of), vector(of.vector(a_bar)) {}
  BodyVectorFeature(const Body&&, const Vector3<Scalar>&) = delete;

  const Vector3<Scalar>& value() const { return vector.a; }
  const Vector3<Scalar>& rate() const { return vector.rate; }
  Scalar bias_along(const Vector3<Scalar>& w) const { return vector.bias.dot(w); }
  Scalar drift_along(const Vector3<Scalar>&) const { return Scalar(0); }
  template <class Row>
  void add_jacobian(const Vector3<Scalar>& w, Row& row) const {
    (end == End::i ? row.rot_i : row.rot_j) += body.jacobian_along(vector, w);
  }
  /// The second derivative of the feature when its bodies accelerate so.
  template <class Acceleration>
  Vector3<Scalar> acceleration(const Acceleration& on_i, const Acceleration& on_j) const {
    return vector.bias + body.jacobian(vector) * (end == End::i ? on_i : on_j).q_ddot;
  }
  FeatureMagnitude<Scalar> magnitude() const {
    const Scalar a = vector.a.norm(), omega = body.omega_bar.norm();
    return {a,
            omega * a,
            omega * omega * a,
            Scalar(0),
            end == End::i ? a : Scalar(0),
            end == End::j ? a : Scalar(0)};
  }
};

/// a = A abar(t): a vector that also turns by itself in its body. Its rate and bias carry the explicit time
/// terms (a_t = A abar_t, and 2 (A abar_t)' + A abar_tt), its drift is a_t alone: nu = f' - Phi_t.
template <BodyKinematics Body, End end>
struct MovingVectorFeature : BodyVectorFeature<Body, end> {
  using Base = BodyVectorFeature<Body, end>;
  using Scalar = typename Body::Scalar;
  Vector3<Scalar> drift, drift_rate;  ///< a_t, and A abar_tt

  MovingVectorFeature(const Body& of, const Vector3<Scalar>& a_bar, const Vector3<Scalar>& a_bar_t,
                      const Vector3<Scalar>& a_bar_tt)
      : Base(of, a_bar) {
    const BodyVector<Scalar> a_t = of.vector(a_bar_t);
    drift = a_t.a;
    drift_rate = of.A * a_bar_tt;
    this->vector.rate += drift;
    this->vector.bias += 2 * a_t.rate + drift_rate;
  }
  MovingVectorFeature(const Body&&, const Vector3<Scalar>&, const Vector3<Scalar>&,
                      const Vector3<Scalar>&) = delete;
  Scalar drift_along(const Vector3<Scalar>& w) const { return drift.dot(w); }
  FeatureMagnitude<Scalar> magnitude() const {
    FeatureMagnitude<Scalar> size = Base::magnitude();
    const Scalar moved = drift.norm();
    size.rate += moved;
    size.bias += 2 * this->body.omega_bar.norm() * moved + drift_rate.norm();
    return size;
  }
};

/// d_ij = (r_j + A_j s_j) - (r_i + A_i s_i); its rate with the velocities of the centres subtracted first, so
/// that a velocity which the bodies share leaves no rounding of its size.
template <BodyKinematics Body>
struct PointOffsetFeature {
  using Scalar = typename Body::Scalar;
  const Body &i, &j;
  BodyVector<Scalar> s_i, s_j;

  /// The bodies must outlive this.
  PointOffsetFeature(const Body& on_i, const Vector3<Scalar>& s_bar_i, const Body& on_j,
                     const Vector3<Scalar>& s_bar_j)
      : i(on_i), j(on_j), s_i(i.vector(s_bar_i)), s_j(j.vector(s_bar_j)) {}
  PointOffsetFeature(const Body&&, const Vector3<Scalar>&, const Body&, const Vector3<Scalar>&) = delete;
  PointOffsetFeature(const Body&, const Vector3<Scalar>&, const Body&&, const Vector3<Scalar>&) = delete;

  Vector3<Scalar> value() const { return offset_between<Scalar>(i.r, s_i.a, j.r, s_j.a); }
  Vector3<Scalar> rate() const { return (j.r_dot - i.r_dot) + (s_j.rate - s_i.rate); }
  Scalar bias_along(const Vector3<Scalar>& w) const { return (s_j.bias - s_i.bias).dot(w); }
  Scalar drift_along(const Vector3<Scalar>&) const { return Scalar(0); }
  template <class Row>
  void add_jacobian(const Vector3<Scalar>& w, Row& row) const {
    row.r_i -= w.transpose();
    row.r_j += w.transpose();
    row.rot_i -= i.jacobian_along(s_i, w);
    row.rot_j += j.jacobian_along(s_j, w);
  }
  template <class Acceleration>
  Vector3<Scalar> acceleration(const Acceleration& on_i, const Acceleration& on_j) const {
    return (s_j.bias - s_i.bias) + (on_j.r_ddot - on_i.r_ddot) +
           (j.jacobian(s_j) * on_j.q_ddot - i.jacobian(s_i) * on_i.q_ddot);
  }
  FeatureMagnitude<Scalar> magnitude() const {
    const Scalar on_i = s_i.a.norm(), on_j = s_j.a.norm();
    const Scalar omega_i = i.omega_bar.norm(), omega_j = j.omega_bar.norm();
    return {value().norm(),
            (j.r_dot - i.r_dot).norm() + omega_i * on_i + omega_j * on_j,
            omega_i * omega_i * on_i + omega_j * omega_j * on_j,
            Scalar(1),
            on_i,
            on_j};
  }
};

}  // namespace trivium
