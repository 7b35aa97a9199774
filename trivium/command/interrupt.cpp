/// The first signal only sets a variable, which the run reads after every step. A signal that
/// arrives more than a second later restores the default action and is raised again, which ends the program.

#include "trivium/command/interrupt.hpp"

#include <csignal>
#include <ctime>
#include <initializer_list>

namespace trivium {

namespace {

volatile std::sig_atomic_t interrupted = 0;
volatile std::time_t interrupted_at = 0;
extern "C" void interrupt(int signal) {
  const std::time_t now = std::time(nullptr);
  if (interrupted == 0) {
    interrupted_at = now;
    interrupted = 1;
  } else if (now > interrupted_at + 1) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, interrupt);
}

bool is_interrupted() { return interrupted != 0; }

}  // namespace trivium
