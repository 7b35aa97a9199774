#pragma once
/// CPU time of this thread, by which runs are compared. What other processes do does not count.

#include <ctime>

namespace trivium {

/// [s], from some point in the past.
inline double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace trivium
