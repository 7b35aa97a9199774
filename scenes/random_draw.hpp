#pragma once
/// Random numbers, directions and rotations from a seed. They do not use the distributions of the standard
/// library, so a seed gives the same numbers on every platform. Compilers evaluate function arguments in
/// different orders: code that needs several random numbers for one call must therefore draw each number in
/// its own statement.

#include <cstdint>
#include <random>

#include "bodies/numbers/vectors.hpp"

namespace trivium::scenes {

/// Draws random numbers, vectors and rotations; one sequence per seed.
class RandomDraw {
 public:
  using V = trivium::Vector3<double>;
  using M = trivium::Matrix3<double>;

  explicit RandomDraw(std::uint64_t seed) : engine_(seed) {}
  /// A number uniform between low and high.
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }
  /// An integer uniform between 0 and n - 1.
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  /// True with probability p.
  bool chance(double p) { return uniform(0, 1) < p; }
  /// A vector whose components are uniform between -size and size.
  V vector(double size = 1) { return size * vector(-1, 1); }
  /// A vector whose components are uniform between low and high.
  V vector(double low, double high) {
    const double z = uniform(low, high), y = uniform(low, high), x = uniform(low, high);
    return {x, y, z};
  }
  /// A random unit vector. Only vectors inside the unit ball are used, so that no direction is preferred;
  /// very short vectors are rejected because rounding would affect their direction.
  V direction() {
    for (;;)
      if (const V v = vector(); v.norm() > 0.2 && v.norm() < 1) return v.normalized();
  }
  /// A random rotation matrix. The limit 0.2 keeps x away from the direction of z, to which x is made normal.
  M rotation() {
    const V z = direction();
    V x = direction();
    while (x.cross(z).norm() < 0.2) x = direction();
    M R;
    R.col(2) = z;
    R.col(0) = (x - z.dot(x) * z).normalized();
    R.col(1) = z.cross(R.col(0));
    return R;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace trivium::scenes
