#pragma once
/// Checks of a scene beyond the grammar of the format, for scenes from files and scenes made in C++. A
/// SceneError names the first violation.
///
/// Magnitudes: every number satisfies |x| <= 1e100. Divisors (masses, lengths, norms of vectors that give a
/// direction, the duration of a step) are at least 1e-100, so that products and squares of the scene's
/// numbers stay finite. Tolerances: rotation matrices are orthonormal within 1e-9, which admits matrices with
/// ten digits. The sine of the angle between `x` and `axis` exceeds 1e-9, so that at least six digits of the
/// joint frame remain in double. Inertia matrices are symmetric, positive semidefinite and obey the
/// triangle inequality within 1e-12 of their trace; a moment that is negative within this tolerance counts as
/// zero. A negative stiffness or damping is allowed.

#include <cstddef>

#include "scenes/format/json.hpp"
#include "scenes/format/scene_error.hpp"
#include "scenes/scene.hpp"

namespace trivium::scenes {

inline constexpr double largest_magnitude = 1e100;   ///< of every number
inline constexpr double smallest_divisor = 1e-100;   ///< of masses, lengths and norms that are divided by
inline constexpr double rotation_tolerance = 1e-9;   ///< of A A^T = I, and of the sine between x and axis
inline constexpr std::size_t most_bodies = 100'000;  ///< protects against hostile files, see json.hpp

/// All checks of a scene except check_magnitudes and check_functions.
void check_scene(const Scene& scene, const Path& root);

/// Checks that no number exceeds the largest magnitude. The check takes a document, where every number has a
/// path.
void check_magnitudes(const Json& json, const Path& at);

/// Checks mass, inertia and orientation of a body.
void check_body(const Body& body, const Path& at);
/// Checks that a constraint has the vectors and parameters that its type uses and no others, and that their
/// values are possible.
void check_constraint(const Constraint& constraint, const Path& at);
/// Checks that all parts of f are present, and that f, f' and f'' are finite at t = 0.
void check_function(const TimeFunction& f, const Path& at);
/// Checks that all functions of time and their first two derivatives are finite at t [s], and that functions
/// of constraints do not jump.
void check_functions(const Scene& scene, double t, const Path& root);
/// Checks that the vector is long enough to have a direction.
void check_direction(const Vector3& vector, const Path& at);

/// The length of the vector, without overflow or underflow of the squares.
double norm(const Vector3& v);

}  // namespace trivium::scenes
