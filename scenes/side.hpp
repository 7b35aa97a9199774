#pragma once
/// Basic types of a scene file: a vector, the index of a body, and one side of a constraint. The type of a
/// constraint determines which vectors its sides have.

#include <array>
#include <optional>

#include "bodies/numbers/vectors.hpp"

namespace trivium::scenes {

/// A vector as a scene file states it.
using Vector3 = std::array<double, 3>;

/// The same vector as an array.
inline Vector3 plain(const trivium::Vector3<double>& v) { return {v[0], v[1], v[2]}; }

/// The index of the implicit body `ground` in a scene. The other bodies count from 0 in the order of the
/// file. (In a Mechanism the ground has the index nb.)
inline constexpr int ground = -1;

/// One side of a constraint. The tables in scene_keys.hpp state which of the vectors a constraint type uses.
struct Side {
  int body = ground;
  std::optional<Vector3> point, vector, axis, x;  ///< body frame; the point in m, the others of any length
  bool operator==(const Side&) const = default;
};

}  // namespace trivium::scenes
