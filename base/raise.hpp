#pragma once
/// The largest and the least of many numbers, where one that is not a number stays. What went wrong once is
/// then not overwritten by what comes after, and no comparison with a bound passes.

#include <cmath>

namespace trivium {

template <class S>
void raise(S& largest, const S& next) {
  if (!(next <= largest) && largest == largest) largest = next;
}
template <class S>
void lower(S& least, const S& next) {
  if (!(next >= least) && least == least) least = next;
}
/// The largest magnitude in a vector; 0 where it is empty.
template <class Vector>
auto largest_magnitude(const Vector& x) {
  using std::abs;
  typename Vector::Scalar largest(0);
  for (const auto& one : x) raise(largest, typename Vector::Scalar(abs(one)));
  return largest;
}

}  // namespace trivium
