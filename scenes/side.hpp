#pragma once
/// A vector as a scene file states it, the number of a body, and one side of a constraint. Which vectors a
/// side has is said by the type of its constraint.

#include <array>
#include <optional>

#include "bodies/numbers/vectors.hpp"

namespace trivium::scenes {

using Vector3 = std::array<double, 3>;

inline Vector3 plain(const trivium::Vector3<double>& v) { return {v[0], v[1], v[2]}; }

/// The index of the implicit body `ground`; other bodies count from 0 in file order.
inline constexpr int ground = -1;

/// One side of a constraint; which of the vectors a type takes is the scene format's table.
struct Side {
  int body = ground;
  std::optional<Vector3> point, vector, axis, x;  ///< body frame
  bool operator==(const Side&) const = default;
};

}  // namespace trivium::scenes
