#pragma once
/// The largest of many numbers, where one that is not a number stays. What went wrong once is then not
/// overwritten by what comes after, and no comparison with a bound passes.

namespace trivium {

template <class S>
void raise(S& largest, const S& next) {
  if (!(next <= largest) && largest == largest) largest = next;
}

}  // namespace trivium
