/// Checks of constraints: their sides, directions and parameters (declared in scene_checks.hpp).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/format/scene_checks.hpp"
#include "scenes/format/scene_keys.hpp"

namespace trivium::scenes {
namespace {

/// The value of f if its form shows that it is constant: a number, or a polynomial without powers of t.
std::optional<double> constant_value(const TimeFunction& f) {
  if (f.is_number()) return std::get<double>(f.kind());
  if (const auto* polynomial = std::get_if<TimeFunction::Polynomial>(&f.kind())) {
    const auto& c = polynomial->coefficients;
    if (std::all_of(c.begin() + 1, c.end(), [](double x) { return x == 0; })) return c.front();
  }
  return std::nullopt;
}

/// The joint frame makes x orthonormal to the axis z, which is impossible if x is parallel to z.
void check_axes(const Vector3& axis, const Vector3& x, const Path& at) {
  const double z_norm = norm(axis), x_norm = norm(x);
  Vector3 z = axis, e = x;
  for (double& component : z) component /= z_norm;
  for (double& component : e) component /= x_norm;
  const double sine = norm({z[1] * e[2] - z[2] * e[1], z[2] * e[0] - z[0] * e[2], z[0] * e[1] - z[1] * e[0]});
  if (!(sine > rotation_tolerance)) fail(at / "x", "a vector along the axis", "a vector off the axis");
}

/// Checks that the side has all required vectors and no unknown ones, and that each except the point has a
/// direction.
void check_side(const Side& side, const Shape& shape, const Path& at) {
  const auto check = [&](std::string_view key, const std::optional<Vector3>& vector) {
    const Key* known = shape.find(key);
    if (vector && !known) fail(at / key, "a vector that this type does not use", "none");
    if (!vector && known && known->required)
      fail(at, "missing key " + in_quotes(key), "an object with " + std::string(key));
    if (vector && key != "point") check_direction(*vector, at / key);
  };
  check("point", side.point);
  check("vector", side.vector);
  check("axis", side.axis);
  check("x", side.x);
  if (side.x && !side.axis) fail(at, "x without an axis", "an object with axis, x");
  if (side.axis && side.x) check_axes(*side.axis, *side.x, at);
}

/// Checks that values without meaning for the type are unset: the writer would lose them.
void check_unused(const Constraint& constraint, const Shape& shape, const Path& at) {
  const Constraint unset;
  const auto check = [&](std::string_view key, bool is_set) {
    if (is_set && !shape.find(key)) fail(at / key, "a value that this type does not use", "none");
  };
  check("f", !(constraint.f == unset.f));
  check("direction", constraint.direction != unset.direction);
  check("distance", constraint.distance != unset.distance);
  check("angle", !(constraint.angle == unset.angle));
}

}  // namespace

void check_direction(const Vector3& vector, const Path& at) {
  if (!(norm(vector) >= smallest_divisor))
    fail(at, "norm " + shortest(norm(vector)),
         fmt::format("a vector with a direction: norm >= {}", shortest(smallest_divisor)));
}

void check_constraint(const Constraint& constraint, const Path& at) {
  const ConstraintShape& shape = shape_of(constraint.type);
  check_unused(constraint, shape.shape, at);
  check_side(constraint.i, *shape.i, at / "i");
  check_side(constraint.j, *shape.j, at / "j");
  check_function(constraint.f, at / "f");
  check_function(constraint.angle, at / "angle");
  if (shape.shape.find("direction")) check_direction(constraint.direction, at / "direction");
  if (properties_of(constraint.type).states_a_distance && !(constraint.distance >= smallest_divisor))
    fail(at / "distance", "found " + shortest(constraint.distance),
         fmt::format("a distance > 0 (at least {})", shortest(smallest_divisor)));
  if (shape.needs_positive_f) {
    const std::optional<double> f = constant_value(constraint.f);
    if (f && !(*f >= smallest_divisor))
      fail(at / "f", fmt::format("found the constant {}", shortest(*f)),
           fmt::format("f > 0 (at least {}): at 0 the row has no gradient", shortest(smallest_divisor)));
  }
}

}  // namespace trivium::scenes
