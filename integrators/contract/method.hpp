#pragma once
/// What a method in time is: one that takes a step of a system and can forget, or shorten, what it did. The
/// walk through a grid of times is integrate.hpp's; lengths of a method's own choice are
/// step_size_control.hpp's.

#include <concepts>

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// What a method has done.
struct Counters {
  long steps = 0, rejected_steps = 0, right_sides = 0, restarts = 0;
  long iterations = 0;  ///< of Newton's method
};

/// One accepted step at a time. `step` moves t and y on by one step, at most to `stop`, which it lands on
/// exactly where it comes near; `restart` forgets what the method remembers of the solution so far, as where
/// it is not smooth; `shorten` has it take a shorter step from where it took the last one, and returns
/// whether it can. Throws an IntegrationError where it gives up.
///
/// A method may have more, which AnyMethod asks for: `lambda`, a pointer to multipliers of its own, null
/// where there are none; `interpolates` with `interpolate(t, y)`, the state at a time of its last step; and,
/// where it keeps something from step to step, `begin(system, t, y, stop)`, `has_begun()` and
/// `show_memory(show)`, by which a run goes on exactly (memory.hpp).
template <class M, class System>
concept Method = requires(M& method, const M& constant, System& system, typename System::Scalar& t,
                          StateVector<typename System::Scalar>& y, const typename System::Scalar& stop) {
  method.step(system, t, y, stop);
  method.restart();
  { method.shorten() } -> std::same_as<bool>;
  { constant.counters() } -> std::convertible_to<Counters>;
};

}  // namespace trivium::integrators
