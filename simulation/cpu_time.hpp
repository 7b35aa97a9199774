#pragma once
/// The CPU time of the calling thread, for the comparison of runs. Other threads and processes do not count.

#include <ctime>

namespace trivium {

/// CPU time since an unspecified moment [s]; only differences have a meaning.
inline double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace trivium
