#pragma once
/// Measures the CPU time of pieces of work with Google Benchmark. The repetitions of all pieces are mixed in
/// random order, so that other load of the machine slows all of them alike.

#include <functional>
#include <vector>

namespace trivium::cost {

/// How long the measurement of one piece of work takes. The defaults are chosen by experiment: smaller
/// numbers give noisy medians, larger numbers only longer measurements.
struct Timing {
  double seconds = 0.03;  ///< shortest time of one repetition [s]
  int repetitions = 7;    ///< an odd number, so that the median is one of the times
};

/// The CPU time [us] of each piece of work in this thread: the median over the repetitions.
std::vector<double> median_microseconds(const std::vector<std::function<void()>>& work, const Timing& timing);

/// The CPU time [s] of one call in this thread.
double seconds_of(const std::function<void()>& work);

}  // namespace trivium::cost
