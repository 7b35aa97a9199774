#pragma once
/// Repeats pieces of work for timing: each round runs all of them once, in random order. Other load of the
/// machine then slows all of them alike. The result is the median of the times.

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace trivium {

/// Calls work(k) for every k < n in each round, in a new random order, and then after_round(). The orders are
/// the same in every run of the program.
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

/// The median of at least one number.
inline double median_of(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return (x[(x.size() - 1) / 2] + x[x.size() / 2]) / 2;
}

}  // namespace trivium
