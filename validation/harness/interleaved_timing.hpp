#pragma once
/// The order in which pieces of work are repeated to be timed: all of them in turn and in random order, so
/// that whatever else the machine does slows all of them alike. The median of the times is taken.

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace trivium {

/// Calls work(k) for every k below n, in another order every round, the same for the same n, and
/// after_round() behind each.
template <class Work, class AfterRound>
void interleave(std::size_t n, int rounds, const Work& work, const AfterRound& after_round) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(1);
  for (int round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t k : order) work(k);
    after_round();
  }
}

/// Of at least one number.
inline double median_of(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return (x[(x.size() - 1) / 2] + x[x.size() / 2]) / 2;
}

}  // namespace trivium
