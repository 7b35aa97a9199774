#include "base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace trivium {

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (visible_) fmt::print(stderr, "\r\033[K");
}

void Progress::step() {
  ++done_;
  const Clock::time_point now = Clock::now();
  using namespace std::chrono_literals;
  if (!terminal_ || now - start_ < 1s || now - drawn_ < 100ms) return;
  drawn_ = now;
  visible_ = true;
  draw();
}

void Progress::draw() const {
  constexpr std::size_t width = 40;
  const std::size_t filled = total_ == 0 ? width : width * done_ / total_;
  fmt::print(stderr, "\r{} [{}{}] {}/{}", what_, std::string(filled, '#'), std::string(width - filled, '.'),
             done_, total_);
  std::fflush(stderr);
}

}  // namespace trivium
