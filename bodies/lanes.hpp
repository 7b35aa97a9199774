#pragma once
/// Decisions in code over any Scalar, spelt so that a Scalar which carries many numbers at once (batch.hpp)
/// takes them lane by lane.

namespace trivium {

inline bool any(bool condition) { return condition; }
inline bool all(bool condition) { return condition; }

/// a where the condition holds, b elsewhere; both are evaluated.
template <class Scalar>
Scalar select(bool condition, const Scalar& a, const Scalar& b) {
  return condition ? a : b;
}

/// The worst of all lanes, for reports.
template <class Scalar>
double largest_lane(const Scalar& x) {
  return static_cast<double>(x);
}

/// The least of all lanes.
template <class Scalar>
const Scalar& least_lane(const Scalar& x) {
  return x;
}

}  // namespace trivium
