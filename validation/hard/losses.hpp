#pragma once
/// What a run of `trivium simulate` loses where memory or a disk is full or a signal ends it: nothing that
/// was computed.

#include "validation/hard/judge.hpp"

namespace trivium::hard {

/// `tries`: how many allocations of a run of the first method fail, each in a run of its own; of the other
/// methods a sixteenth as many, since most allocations are the same. At most all of them.
void judge_allocations(Judge& judge, double tries);

/// `bytes`: the size to which a file can grow.
void judge_full_disk(Judge& judge, double bytes);

/// `runs` of the first method, and a sixteenth as many of others, get a signal within half a second.
void judge_interrupt(Judge& judge, double runs);
void judge_termination(Judge& judge, double runs);

}  // namespace trivium::hard
