/// Increases the inertia of every body that other codes would refuse, and leaves all other bodies as they
/// are.

#include "validation/simbody/physical_inertia.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/raise.hpp"
#include "bodies/inertia.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium {

namespace {

/// Key visitor that finds the largest distance from a body's centre of mass to an end of a spring on this
/// body.
struct Reach : KeyVisitor {
  int of;
  double& reach;

  Reach(int body_index, double& out) : of(body_index), reach(out) {}

  void take(int on, const Vector3<double>& s_bar) const {
    if (on == of) raise(reach, std::hypot(s_bar[0], s_bar[1], s_bar[2]));
  }
  void point(std::string_view, const BodyPoint<double>& end) const { take(end.body, end.s_bar); }
};

double reach_of(const scenes::Scene& scene, int body) {
  double reach = 0;
  const Reach visitor(body, reach);
  for (const scenes::Constraint& c : scene.constraints)
    for (const scenes::Side& side : {c.i, c.j})
      if (side.point) visitor.take(side.body, Vector3<double>(side.point->data()));
  for (const scenes::Effect& effect : scene.effects) scenes::visit_keys(visitor, effect);
  return reach;
}

}  // namespace

scenes::Scene physical_twin(scenes::Scene scene) {
  const auto mechanism = make_mechanism<double>(scene);
  for (int b = 0; b < mechanism.nb(); ++b) {
    Matrix3<double> J = mechanism.bodies[b].inertia;
    const InertiaCheck check = check_inertia(J);
    const Vector3<double>& moment = check.principal_moments;
    if (check.physical() && moment[0] > inertia_tolerance * J.trace()) continue;
    const double reach = reach_of(scene, b), mass = mechanism.bodies[b].mass;
    const double size = J.trace() + mass * reach * reach;
    // the header has the formula and the reason of 1/100
    J.diagonal().array() += std::max(0.0, moment[2] - moment[1] - moment[0]) + (size > 0 ? size : mass) / 100;
    scenes::Body& body = scene.bodies[static_cast<std::size_t>(b)];
    scenes::Matrix3 rows;
    for (int k = 0; k < 3; ++k) rows[static_cast<std::size_t>(k)] = {J(k, 0), J(k, 1), J(k, 2)};
    body.inertia = rows;
    body.unphysical_inertia = false;
  }
  return scene;
}

}  // namespace trivium
