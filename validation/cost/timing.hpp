#pragma once
/// Measures the CPU time of pieces of work with Google Benchmark. The repetitions of all pieces are mixed in
/// random order, so that other load of the machine slows all of them alike.

#include <functional>
#include <vector>

namespace trivium::cost {

struct Timing {
  double seconds = 0.03;  ///< shortest time of one repetition [s]
  int repetitions = 7;
};

/// The CPU time [us] of each piece of work in this thread: the median over the repetitions.
std::vector<double> median_microseconds(const std::vector<std::function<void()>>& work, const Timing& timing);

/// The CPU time [s] of one call in this thread.
double seconds_of(const std::function<void()>& work);

}  // namespace trivium::cost
