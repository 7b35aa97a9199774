#pragma once
/// A seeded source of numbers, vectors, directions and Euler parameters. A support of the tests.

#include <cstdint>
#include <random>

#include "bodies/numbers/vectors.hpp"

namespace trivium::test {

/// Numbers from a fixed seed, the same on every machine (the standard's distributions are not). All are
/// doubles, so that every Scalar starts from exactly the same values.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low = -1, double high = 1) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// 0 ... n - 1.
  int index(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  bool chance(double probability) { return uniform(0, 1) < probability; }

  template <class S, int N>
  Vector<S, N> vector(double size = 1) {
    Vector<S, N> v;
    for (int k = 0; k < N; ++k) v[k] = S(uniform(-size, size));
    return v;
  }
  /// A direction, unit to the last bit of S.
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
