#pragma once
/// Features: the vectors from which basic constraints are made. A feature x is a vector with global
/// components that moves with the bodies: a constant, a body vector a = A a_bar, or the offset d_ij between
/// two points. A basic constraint is the dot product of two features minus f(t). In the coordinates q of a
/// formulation
///
///     x' = x_q q' + drift,   x'' = x_q q'' + bias,   drift = x_t (explicit dependence on time)
///
/// Every feature has
///
///     value(), rate()                   x and x'
///     bias_along(w), drift_along(w)     w . bias and w . drift
///     add_jacobian(w, row)              adds w^T x_q to the Jacobian blocks of the row
///     acceleration(on_i, on_j)          x'' for given accelerations of bodies i and j
///     magnitude()                       bounds of x and its derivatives (FeatureMagnitude)

#include "bodies/point_offset.hpp"
#include "constraints/body_kinematics.hpp"

namespace trivium {

/// Bounds of a feature and of its derivatives, for estimates of rounding errors: every bound is the sum of
/// the norms of the terms, so that no terms cancel.
template <class Scalar>
struct FeatureMagnitude {
  /// Bounds of x, of x', of the bias in r-omega, of the derivative of x by r of either body, and of the
  /// derivatives of x by a small rotation of body i and of body j.
  Scalar value{0}, rate{0}, bias{0}, r{0}, rot_i{0}, rot_j{0};
};

/// A vector that is constant in the global frame.
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

/// a = A a_bar, a vector fixed in body i or in body j.
template <BodyKinematics Body, End end>
struct BodyVectorFeature {
  using Scalar = typename Body::Scalar;
  const Body& body;
  BodyVector<Scalar> vector;

  /// Keeps a reference to the body, which must outlive this object.
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
  /// a'' for the given accelerations of bodies i and j (BodyAcceleration).
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

/// a = A a_bar(t), a vector that moves relative to its body in a prescribed way. Its drift A a_bar_t is also
/// a term of the rate, and 2 A' a_bar_t + A a_bar_tt are terms of the bias.
template <BodyKinematics Body, End end>
struct MovingVectorFeature : BodyVectorFeature<Body, end> {
  using Base = BodyVectorFeature<Body, end>;
  using Scalar = typename Body::Scalar;
  Vector3<Scalar> drift, drift_rate;  ///< A a_bar_t and A a_bar_tt [global]

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

/// d_ij = (r_j + A_j s_bar_j) - (r_i + A_i s_bar_i) [m, global]. The velocities of the centres are subtracted
/// first, so that a large common velocity of the bodies causes no rounding error of its size.
template <BodyKinematics Body>
struct PointOffsetFeature {
  using Scalar = typename Body::Scalar;
  const Body &i, &j;
  BodyVector<Scalar> s_i, s_j;

  /// Keeps references to the bodies, which must outlive this object; points s_bar [m, body frames].
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
  /// The offset, and the difference of the velocities of the centres, count as one term each, because value()
  /// and rate() form these differences first. All formulations subtract the same given numbers here. A
  /// cancellation magnifies the errors of these data, equally in every formulation, and is no error of the
  /// arithmetic.
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
