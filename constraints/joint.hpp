#pragma once
/// The rows of every joint (`rows_of`): a joint is a sequence of basic constraints, in a documented order
/// that is also the order of its multipliers. Haug (1989), section 9.4. The joint axes u, v, z, the default x
/// axis and the sign of the rotation driver's row are defined here.

#include <string>
#include <utility>
#include <vector>

#include "constraints/basic_constraint.hpp"
#include "constraints/constraint_type.hpp"

namespace trivium {

/// The point and the axes of a joint on one body. (u, v, z) is orthonormal and right-handed.
template <class Scalar>
struct JointFrame {
  Vector3<Scalar> point = Vector3<Scalar>::Zero();  ///< joint point [m, body frame]
  /// z is the joint axis, u is perpendicular to z, v = z x u [-, body frame].
  Vector3<Scalar> u = Vector3<Scalar>::Unit(0), v = Vector3<Scalar>::Unit(1), z = Vector3<Scalar>::Unit(2);

  /// Calls use(a.m, b.m, ...) for every member m, where a, b, ... are the given frames.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.point...);
    use(p.u...);
    use(p.v...);
    use(p.z...);
  }
};

/// The joint frame with z = axis / |axis| and u the normalised part of x perpendicular to z. All arguments
/// are in the body frame; `axis` and `x` must not be zero or parallel (not checked here).
template <class Scalar>
JointFrame<Scalar> joint_frame(const Vector3<Scalar>& point, const Vector3<Scalar>& axis,
                               const Vector3<Scalar>& x) {
  JointFrame<Scalar> frame;
  frame.point = point;
  frame.z = axis / axis.stableNorm();
  const Vector3<Scalar> e = x / x.stableNorm();  // normalised first, so that no square over- or underflows
  frame.u = e - frame.z.dot(e) * frame.z;
  frame.u /= frame.u.norm();
  frame.v = frame.z.cross(frame.u);
  return frame;
}

/// The default x of an axis: the unit vector e_k with the smallest |axis_k|, lowest k on ties.
inline Vector3<double> default_x(const Vector3<double>& axis) {
  Eigen::Index k;
  axis.cwiseAbs().minCoeff(&k);
  return Vector3<double>::Unit(k);
}

/// A basic constraint as a row of a joint.
template <class Scalar>
struct NamedRow {
  std::string label;  ///< name within the joint, e.g. "dp1(u_i, z_j)"
  BasicConstraint<Scalar> constraint;
};
/// The rows of one joint, in the order of their multipliers.
template <class Scalar>
using JointRows = std::vector<NamedRow<Scalar>>;

/// Builds the rows of a joint between a frame on body i and a frame on body j. The free motions of j relative
/// to i, along and about the axes u, v, z of i: spherical 3 rotations; universal 2 rotations, about z_i and
/// z_j; revolute 1 rotation about z; cylindrical rotation about z and translation along z; translational
/// translation along z; fixed none; planar rotation about z and translations along u and v; in_line all but
/// translations along u and v; in_plane all but translation along z; distance all but translation along d_ij;
/// rotation_driver all but rotation about z.
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
  /// The joint points keep the distance `length` [m]: a row D with f = length^2.
  JointRows<Scalar> distance(double length) const {
    return {{"d", D<Scalar>{bodies_, i_.point, j_.point,
                            TimeFunction::Product{{TimeFunction(length), TimeFunction(length)}}}}};
  }
  /// sin(theta - alpha(t)) = 0 with theta [rad] from u_i to u_j about z_i. On the branch theta = alpha the
  /// derivative by theta is 1, so the torque on j about z is -lambda [N m].
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

/// The rows of a joint of any type; empty for JointType::basic. `distance` [m] is used by the type `distance`
/// only, `angle` = alpha(t) [rad] by `rotation_driver` only.
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
