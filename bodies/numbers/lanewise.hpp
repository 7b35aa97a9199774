#pragma once
/// Conditions in code over any Scalar: select, larger, all, any. For a plain number they are the usual
/// operations. For a Batch (batch.hpp), which holds several numbers, they decide for each lane separately.

#include <stdexcept>

namespace trivium {

/// Thrown by an `if` whose condition differs between the lanes of a Batch: these states take different
/// branches and cannot be computed together.
class MixedLanes : public std::runtime_error {
 public:
  MixedLanes()
      : std::runtime_error(
            "the states of a batch take different branches of the algorithm; solve these states one at a "
            "time") {}
};

/// Whether a condition holds in any lane.
inline bool any(bool condition) { return condition; }
/// Whether a condition holds in all lanes.
inline bool all(bool condition) { return condition; }
/// Whether one of two conditions holds, in each lane.
inline bool either(bool one, bool other) { return one || other; }

/// `a` if the condition holds, otherwise `b`, in each lane. Both are always evaluated.
template <class Scalar>
Scalar select(bool condition, const Scalar& a, const Scalar& b) {
  return condition ? a : b;
}

/// max(a, b), in each lane; NaN if either is NaN.
template <class Scalar>
Scalar larger(const Scalar& a, const Scalar& b) {
  return select(either(a > b, a != a), a, b);
}

/// The maximum over all lanes, for reports; NaN if a lane is NaN. The value itself for a plain number.
template <class Scalar>
double largest_lane(const Scalar& x) {
  return static_cast<double>(x);
}

/// The minimum over all lanes; the value itself for a plain number.
template <class Scalar>
const Scalar& least_lane(const Scalar& x) {
  return x;
}

}  // namespace trivium
