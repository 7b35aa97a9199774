#pragma once
/// Ctrl-C during a run. The first SIGINT or SIGTERM ends the run after the current step, so that its results
/// are kept. A signal two or more seconds later ends the program at once. Signals in between are ignored: a
/// terminal may send the same Ctrl-C both to the process and to its group.

namespace trivium {

/// Installs the signal handlers.
void catch_interrupts();

/// Whether a signal has arrived since.
bool is_interrupted();

}  // namespace trivium
