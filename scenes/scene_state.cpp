#include "scenes/scene_state.hpp"

namespace trivium {

void set_state(scenes::Scene& scene, const MechanismState<double>& state) {
  scene.saved.reset();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    scenes::Body& body = scene.bodies[b];
    const auto store = [](const Vector3<double>& v) { return scenes::Vector3{v[0], v[1], v[2]}; };
    body.position = store(state.pose[b].r);
    const Vector4<double>& p = state.pose[b].p;
    body.orientation = scenes::EulerParameters{{p[0], p[1], p[2], p[3]}};
    body.velocity = store(state.twist[b].r_dot);
    body.angular_velocity = store(state.twist[b].omega_bar);
  }
}

}  // namespace trivium
