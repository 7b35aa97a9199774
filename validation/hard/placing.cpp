#include "validation/hard/placing.hpp"

#include "bodies/rotations/so3.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium::hard {

namespace {

using Vector = Vector3<double>;

MechanismState<double> state_of(const scenes::Body& body) {
  scenes::Scene alone;
  alone.bodies = {body};
  return make_state<double>(alone);
}

Vector vector(const scenes::Vector3& x) { return {x[0], x[1], x[2]}; }

}  // namespace

void pin_at_origin(scenes::Body& body, const scenes::Vector3& on_body) {
  const MechanismState<double> state = state_of(body);
  const auto A = rotation_matrix(state.pose[0].p);
  const Vector s = vector(on_body);
  body.position = scenes::plain(-A * s);
  body.velocity = scenes::plain(-A * state.twist[0].omega_bar.cross(s));
}

scenes::Vector3 direction_in_ground(const scenes::Body& body, const scenes::Vector3& on_body) {
  return scenes::plain(rotation_matrix(state_of(body).pose[0].p) * vector(on_body));
}

}  // namespace trivium::hard
