#include "validation/simbody/physical_inertia.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/inertia.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium {

namespace {

double reach_of(const scenes::Scene& scene, int body) {
  double reach = 0;
  const auto take = [&](const scenes::Side& side) {
    if (side.body == body && side.point)
      reach = std::max(reach, std::hypot((*side.point)[0], (*side.point)[1], (*side.point)[2]));
  };
  for (const scenes::Constraint& c : scene.constraints) take(c.i), take(c.j);
  for (const scenes::Effect& effect : scene.effects)
    if (const auto* spring = std::get_if<scenes::SpringDamper>(&effect)) take(spring->i), take(spring->j);
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
