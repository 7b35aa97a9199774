#pragma once
/// A seeded generator of random numbers, vectors, directions and Euler parameters. Used by tests only.

#include <cstdint>
#include <random>

#include "bodies/numbers/vectors.hpp"

namespace trivium::test {

/// Does not use the distributions of the C++ standard, because their values differ between standard
/// libraries. Numbers are drawn as doubles, so that they are the same in every Scalar.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low = -1, double high = 1) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// A random index in 0 ... n - 1.
  int index(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  bool chance(double probability) { return uniform(0, 1) < probability; }

  template <class S, int N>
  Vector<S, N> vector(double size = 1) {
    Vector<S, N> v;
    for (int k = 0; k < N; ++k) v[k] = S(uniform(-size, size));
    return v;
  }
  /// A random direction, with norm 1 up to the rounding of S. Uniform: vectors outside the unit ball are
  /// drawn again, also those shorter than 0.1, because the zero vector has no direction.
  template <class S, int N = 3>
  Vector<S, N> direction() {
    for (;;) {
      const Vector<S, N> v = vector<S, N>();
      const S size = v.norm();
      if (size > S(0.1) && size < S(1)) return v / size;
    }
  }
  template <class S>
  Vector4<S> euler_parameters() {
    return direction<S, 4>();
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace trivium::test
