#pragma once
/// What a scene must satisfy beyond its grammar, whoever made it. A SceneError names the first thing that
/// does not.
///
/// Magnitudes: |x| <= 1e100 for every number, and at least 1e-100 for what is divided by (masses, lengths,
/// norms of vectors that give a direction, the duration of a step), so that products and squares of what a
/// scene states stay finite. Tolerances: rotation matrices are orthonormal, and `x` is off `axis`, within
/// 1e-9; inertias are symmetric, positive semidefinite and triangular within 1e-12 of their trace, and a
/// moment below zero within that counts as zero. A negative stiffness or damping is a model, not an error.

#include <cstddef>

#include "scenes/format/json.hpp"
#include "scenes/format/scene_error.hpp"
#include "scenes/scene.hpp"

namespace trivium::scenes {

inline constexpr double largest_magnitude = 1e100;
inline constexpr double smallest_divisor = 1e-100;
inline constexpr double rotation_tolerance = 1e-9;
inline constexpr std::size_t most_bodies = 100'000;

/// All of them, except the magnitudes.
void check_scene(const Scene& scene, const Path& root);

/// No number is beyond the largest magnitude; in a document, where the place of each is known.
void check_magnitudes(const Json& json, const Path& at);

void check_body(const Body& body, const Path& at);
void check_constraint(const Constraint& constraint, const Path& at);
/// Its parts are complete, and f, f' and f'' are finite at t = 0.
void check_function(const TimeFunction& f, const Path& at);
/// f, f' and f'' of every function of time are finite at t.
void check_functions(const Scene& scene, double t, const Path& root);
/// The vector has a direction.
void check_direction(const Vector3& vector, const Path& at);

double norm(const Vector3& v);

}  // namespace trivium::scenes
