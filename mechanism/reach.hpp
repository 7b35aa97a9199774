#pragma once
/// How far the points of a body move when it turns. With this length rotations and translations are compared.

#include <cmath>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// By body, how far its points move by a rotation of 1 rad [m]: the distance of the farthest joint point from
/// the centre of mass, or the radius of gyration if this is larger.
template <class S, class Types>
std::vector<S> reaches(const Mechanism<S, Types>& mechanism) {
  using std::sqrt;
  std::vector<S> reach;
  for (const RigidBody<S>& body : mechanism.bodies)
    reach.push_back(sqrt(body.inertia.trace() / (2 * body.mass)));
  for (const Joint<S>& joint : mechanism.joints)
    for (const auto& [b, point] : {std::pair(joint.i, joint.frame_i.point), {joint.j, joint.frame_j.point}})
      if (b < mechanism.nb()) raise(reach[b], S(point.norm()));
  return reach;
}

}  // namespace trivium
