#pragma once
/// The rows of every joint (rows_of): a union of basic constraints in a documented order. A joint's
/// multipliers are those of its rows. Haug (1989), section 9.4.
///
/// Decided here: the axes u, v, z of a joint, the default x axis, and the branch of a rotation driver.

#include <string>
#include <utility>
#include <vector>

#include "constraints/basic_constraint.hpp"
#include "constraints/constraint_type.hpp"

namespace trivium {

/// A joint's point and axes on one body, in the body frame: z the axis, u orthonormal to it, v = z x u.
template <class Scalar>
struct JointFrame {
  Vector3<Scalar> point = Vector3<Scalar>::Zero();
  Vector3<Scalar> u = Vector3<Scalar>::Unit(0), v = Vector3<Scalar>::Unit(1), z = Vector3<Scalar>::Unit(2);

  /// use(part...) for every part of one frame or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.point...);
    use(p.u...);
    use(p.v...);
    use(p.z...);
  }
};

/// The frame of an axis: z = axis normalised; u is x made orthonormal to z.
template <class Scalar>
JointFrame<Scalar> joint_frame(const Vector3<Scalar>& point, const Vector3<Scalar>& axis,
                               const Vector3<Scalar>& x) {
  JointFrame<Scalar> frame;
  frame.point = point;
  frame.z = axis / axis.stableNorm();
  const Vector3<Scalar> e = x / x.stableNorm();  // first to unit size: no square may over- or underflow
  frame.u = e - frame.z.dot(e) * frame.z;
  frame.u /= frame.u.norm();
  frame.v = frame.z.cross(frame.u);
  return frame;
}

/// The x of an axis with none given: the unit vector e_k with the smallest |z_k|, lowest k on ties.
inline Vector3<double> default_x(const Vector3<double>& axis) {
  Eigen::Index k;
  axis.cwiseAbs().minCoeff(&k);
  return Vector3<double>::Unit(k);
}

/// A basic constraint and what it is called within its joint, e.g. "dp1(u_i, z_j)".
template <class Scalar>
struct NamedRow {
  std::string label;
  BasicConstraint<Scalar> constraint;
};
template <class Scalar>
using JointRows = std::vector<NamedRow<Scalar>>;

/// Builds the rows of every joint type between two frames.
template <class Scalar>
class JointBuilder {
 public:
  JointBuilder(BodyPair bodies, JointFrame<Scalar> i, JointFrame<Scalar> j)
      : bodies_(bodies), i_(std::move(i)), j_(std::move(j)) {}

  JointRows<Scalar> spherical() const { return {cd("cd(e_x)", 0), cd("cd(e_y)", 1), cd("cd(e_z)", 2)}; }
  JointRows<Scalar> universal() const { return join(spherical(), {dp1("dp1(z_i, z_j)", i_.z, j_.z)}); }
  JointRows<Scalar> revolute() const { return join(spherical(), parallel_axes()); }
  JointRows<Scalar> cylindrical() const { return join(parallel_axes(), in_line()); }
  JointRows<Scalar> translational() const { return join(cylindrical(), no_rotation()); }
  JointRows<Scalar> fixed() const { return join(revolute(), no_rotation()); }
  JointRows<Scalar> planar() const { return join(parallel_axes(), in_plane()); }
  JointRows<Scalar> in_line() const { return {dp2("dp2(u_i)", i_.u), dp2("dp2(v_i)", i_.v)}; }
  JointRows<Scalar> in_plane() const { return {dp2("dp2(z_i)", i_.z)}; }
  /// Points a given length apart: d with f = length^2.
  JointRows<Scalar> distance(double length) const {
    return {{"d", D<Scalar>{bodies_, i_.point, j_.point,
                            TimeFunction::Product{{TimeFunction(length), TimeFunction(length)}}}}};
  }
  /// sin(theta - alpha(t)) = 0, theta from u_i to u_j about z_i; on its proper branch the torque on j about z
  /// is -lambda.
  JointRows<Scalar> rotation_driver(const TimeFunction& alpha) const {
    return {{"dp1(w_i, u_j)", TurningDP1<Scalar>{bodies_, i_.u, i_.v, j_.u, alpha}}};
  }

 private:
  static JointRows<Scalar> join(JointRows<Scalar> a, const JointRows<Scalar>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }
  JointRows<Scalar> parallel_axes() const {
    return {dp1("dp1(u_i, z_j)", i_.u, j_.z), dp1("dp1(v_i, z_j)", i_.v, j_.z)};
  }
  JointRows<Scalar> no_rotation() const { return {dp1("dp1(u_i, v_j)", i_.u, j_.v)}; }
  NamedRow<Scalar> dp1(std::string label, const Vector3<Scalar>& a_i, const Vector3<Scalar>& a_j) const {
    return {std::move(label), DP1<Scalar>{bodies_, a_i, a_j, {}}};
  }
  NamedRow<Scalar> dp2(std::string label, const Vector3<Scalar>& a_i) const {
    return {std::move(label), DP2<Scalar>{bodies_, a_i, i_.point, j_.point, {}}};
  }
  NamedRow<Scalar> cd(std::string label, int k) const {
    return {std::move(label), CD<Scalar>{bodies_, Vector3<Scalar>::Unit(k), i_.point, j_.point, {}}};
  }

  BodyPair bodies_;
  JointFrame<Scalar> i_, j_;
};

/// The rows of a joint of any type; `distance` [m] and `angle`, alpha(t) [rad], are those of the types that
/// have one.
template <class Scalar>
JointRows<Scalar> rows_of(JointType type, const BodyPair& bodies, const JointFrame<Scalar>& i,
                          const JointFrame<Scalar>& j, double distance, const TimeFunction& angle) {
  const JointBuilder<Scalar> build(bodies, i, j);
  switch (type) {
    case JointType::basic:
      return {};
    case JointType::spherical:
      return build.spherical();
    case JointType::universal:
      return build.universal();
    case JointType::revolute:
      return build.revolute();
    case JointType::cylindrical:
      return build.cylindrical();
    case JointType::translational:
      return build.translational();
    case JointType::fixed:
      return build.fixed();
    case JointType::planar:
      return build.planar();
    case JointType::in_line:
      return build.in_line();
    case JointType::in_plane:
      return build.in_plane();
    case JointType::distance:
      return build.distance(distance);
    case JointType::rotation_driver:
      return build.rotation_driver(angle);
  }
  return {};
}

}  // namespace trivium
