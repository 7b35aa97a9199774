#pragma once
/// Ctrl-C during a run. The first SIGINT or SIGTERM ends the run after the current step, so that its results
/// are kept. A later signal ends the program at once, unless it arrives within a second: a terminal may send
/// the same Ctrl-C both to the process and to its group. The clock counts whole seconds, so that the second
/// may last up to two.

namespace trivium {

/// Installs the signal handlers.
void catch_interrupts();

/// Whether a signal has arrived since.
bool is_interrupted();

}  // namespace trivium
