#pragma once
/// How long pieces of work take, all of them in turn and in random order, so that what else the machine does
/// meets them alike. By Google Benchmark.

#include <functional>
#include <vector>

namespace trivium::cost {

struct Timing {
  double seconds = 0.03;  ///< at least, a repetition
  int repetitions = 7;
};

/// The median over the repetitions of each one's CPU time in this thread, in microseconds.
std::vector<double> median_microseconds(const std::vector<std::function<void()>>& work, const Timing& timing);

/// The CPU time of one call in this thread, in seconds.
double seconds_of(const std::function<void()>& work);

}  // namespace trivium::cost
