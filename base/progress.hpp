#pragma once
/// A progress bar on stderr. It shows only where stderr is a terminal and the work exceeds a second, so that
/// logs stay free of it.

#include <chrono>
#include <string>

namespace trivium {

class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress();
  /// One more item done.
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
