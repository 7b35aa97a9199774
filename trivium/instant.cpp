/// Finds numbers by the names of bodies, joints and rows, and computes the motion of body-fixed points.

#include "trivium/instant.hpp"

#include "bodies/rotations/so3.hpp"
#include "trivium/choices.hpp"
#include "trivium/plain.hpp"

namespace trivium {

namespace {

std::size_t find(std::string_view noun, const std::vector<std::string>& names, std::string_view name) {
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return k;
  refuse_name(noun, name, names);
}

/// The names of an instant; an instant that was only default-constructed has none.
const Names& names_of(const Instant& instant) {
  static const Names none;
  return instant.names ? *instant.names : none;
}

Vector3<double> vector(const Components& v) { return Vector3<double>(v.data()); }

}  // namespace

const BodyInstant& Instant::body(std::string_view name) const {
  return bodies[find("body", names_of(*this).bodies, name)];
}

const JointReaction& Instant::reaction(std::string_view joint) const {
  return reactions[find("joint", names_of(*this).joints, joint)];
}

double Instant::lambda_of(std::string_view row) const {
  return lambda[find("row", names_of(*this).rows, row)];
}

PointMotion Instant::point(std::string_view name, const Components& s_bar) const {
  const BodyInstant& at = body(name);
  const Matrix3<double> A = rotation_matrix<double>(Vector4<double>(at.p.data()));
  const Vector3<double> s = vector(s_bar), omega = vector(at.omega_bar), omega_dot = vector(at.omega_bar_dot);
  const Vector3<double> position = vector(at.r) + A * s, velocity = vector(at.r_dot) + A * omega.cross(s),
                        acceleration =
                            vector(at.r_ddot) + A * (omega_dot.cross(s) + omega.cross(omega.cross(s)));
  return {plain(position), plain(velocity), plain(acceleration)};
}

}  // namespace trivium
