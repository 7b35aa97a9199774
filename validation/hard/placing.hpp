#pragma once
/// Places bodies of generated scenes so that they satisfy their joints exactly. Only their orientation and
/// angular velocity are chosen.

#include "scenes/scene.hpp"

namespace trivium::hard {

/// Moves a body, with its orientation and angular velocity, so that its point `on_body` is at the origin and
/// stands still.
void pin_at_origin(scenes::Body& body, const scenes::Vector3& on_body);

/// The global components of a vector that is given in the frame of the body.
scenes::Vector3 direction_in_ground(const scenes::Body& body, const scenes::Vector3& on_body);

}  // namespace trivium::hard
