#pragma once
/// Decisions in code over any Scalar: select, larger, all, any. They are spelt so that a Scalar which carries
/// many numbers at once (batch.hpp) takes them lane by lane; for a plain number they are what they say.

#include <stdexcept>

namespace trivium {

/// A branch asked for one answer and the lanes gave two: these states cannot go in lockstep.
class MixedLanes : public std::runtime_error {
 public:
  MixedLanes()
      : std::runtime_error(
            "the states of a batch take different branches of the algorithm; solve these states one at a "
            "time") {}
};

inline bool any(bool condition) { return condition; }
inline bool all(bool condition) { return condition; }
inline bool either(bool one, bool other) { return one || other; }

/// a where the condition holds, b elsewhere; both are evaluated.
template <class Scalar>
Scalar select(bool condition, const Scalar& a, const Scalar& b) {
  return condition ? a : b;
}

/// What is not a number is larger than any.
template <class Scalar>
Scalar larger(const Scalar& a, const Scalar& b) {
  return select(either(a > b, a != a), a, b);
}

/// The worst of all lanes, for reports; a NaN is worst.
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
