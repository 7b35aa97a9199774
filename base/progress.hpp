#pragma once
/// A progress bar on stderr. It appears only if stderr is a terminal and the work takes longer than one
/// second, so that log files do not contain it.

#include <chrono>
#include <string>

namespace trivium {

/// The bar shows `what`, the number of finished items and their total.
class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress();
  /// Counts one more finished item and redraws the bar, at most ten times per second.
  void step();

 private:
  void draw() const;

  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::size_t total_, done_ = 0;
  Clock::time_point start_ = Clock::now(), drawn_ = start_;
  bool terminal_, visible_ = false;
};

}  // namespace trivium
