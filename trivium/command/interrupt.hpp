#pragma once
/// Ctrl-C during a run: the first one (or SIGTERM) ends the run after the step at hand, so that what was
/// computed is kept; one two seconds later or more ends the program. Those between are taken for the same
/// one, which a terminal sends to a process and to its group.

namespace trivium {

/// From now on an interrupt does not end the program, but is there to be asked for.
void catch_interrupts();

bool is_interrupted();

/// Of a run that an interrupt ended: 128 + SIGINT, as shells have it.
constexpr int exit_interrupted = 130;

}  // namespace trivium
