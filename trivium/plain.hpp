#pragma once
/// Conversions from the library's types (Eigen vectors) to the plain types of the public interface. Only the
/// library's own sources include this header.

#include "bodies/reaction.hpp"
#include "mechanism/model.hpp"
#include "trivium/instant.hpp"

namespace trivium {

/// The three components of v.
inline Components plain(const Vector3<double>& v) { return {v[0], v[1], v[2]}; }
/// The numbers of v.
inline std::vector<double> plain(const VectorX<double>& v) { return {v.begin(), v.end()}; }
/// A reaction, with its units and frames.
inline JointReaction plain(const Reaction<double>& r) {
  return {plain(r.force), plain(r.torque), plain(r.point)};
}

/// The names of bodies, joints and rows, and the two bodies of every joint.
inline Names names_of(const Mechanism<double>& mechanism) {
  Names names{{}, {}, mechanism.row_names, {}, {}};
  for (int b = 0; b < mechanism.nb(); ++b) names.bodies.push_back(mechanism.body_names[b]);
  for (const Joint<double>& joint : mechanism.joints) {
    names.joints.push_back(joint.name);
    names.joint_bodies_i.push_back(mechanism.body_names[joint.i]);
    names.joint_bodies_j.push_back(mechanism.body_names[joint.j]);
  }
  return names;
}

/// Poses, twists and accelerations per body. Accelerations are 0 if the vectors of accelerations are empty.
inline std::vector<BodyInstant> plain_bodies(const MechanismState<double>& state,
                                             const std::vector<Vector3<double>>& r_ddot,
                                             const std::vector<Vector3<double>>& omega_bar_dot) {
  std::vector<BodyInstant> bodies(state.pose.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Vector4<double>& p = state.pose[b].p;
    bodies[b] = {plain(state.pose[b].r),   plain(state.twist[b].r_dot),     {},
                 {p[0], p[1], p[2], p[3]}, plain(state.twist[b].omega_bar), {}};
    if (b < r_ddot.size()) bodies[b].r_ddot = plain(r_ddot[b]);
    if (b < omega_bar_dot.size()) bodies[b].omega_bar_dot = plain(omega_bar_dot[b]);
  }
  return bodies;
}

}  // namespace trivium
