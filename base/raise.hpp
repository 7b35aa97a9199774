#pragma once
/// Running maximum and minimum that keep NaN. If one of the values is NaN, the result is NaN whatever values
/// follow, so that no later comparison with a bound passes by accident.

#include <cmath>

namespace trivium {

/// largest = max(largest, next); NaN if either is NaN.
template <class S>
void raise(S& largest, const S& next) {
  if (!(next <= largest) && largest == largest) largest = next;
}
/// least = min(least, next); NaN if either is NaN.
template <class S>
void lower(S& least, const S& next) {
  if (!(next >= least) && least == least) least = next;
}
/// max |x_k|; 0 for an empty vector, NaN if an entry is NaN.
template <class Vector>
auto largest_magnitude(const Vector& x) {
  using std::abs;
  typename Vector::Scalar largest(0);
  for (const auto& one : x) raise(largest, typename Vector::Scalar(abs(one)));
  return largest;
}

}  // namespace trivium
