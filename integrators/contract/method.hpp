#pragma once
/// The contract of a method in time: it takes one step of a system. It can forget all earlier steps
/// (restart), and make its next step shorter after the last one was taken back (shorten). integrate.hpp walks
/// through the time grid; step_size_control.hpp chooses step sizes.

#include <concepts>

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// The work of a method so far.
struct Counters {
  /// Steps accepted and rejected; evaluations of the model; restarts after discontinuities and chart changes.
  long steps = 0, rejected_steps = 0, right_sides = 0, restarts = 0;
  long iterations = 0;  ///< Newton iterations
};

/// A method takes one accepted step at a time. `step` moves t and y by one step: with given steps
/// exactly to `stop`, with chosen steps at most to it. A step that would end within rounding of `stop` ends
/// on it exactly. `step` throws an IntegrationError if the method fails. `restart` forgets the solution so
/// far, which is necessary where the solution is not smooth. `shorten` is called if the last step is taken
/// back: the caller restores t and y, and the next step is shorter. It returns false if the method cannot
/// shorten its steps.
///
/// Optional functions, which AnyMethod asks for:
///
///   lambda               a pointer to the raw lambda (any_method.hpp), or null
///   interpolates, interpolate(t, y)
///                        the state at a time within the last step
///   begin(system, t, y, stop), has_begun, show_memory(show)
///                        the memory (memory.hpp). With it a saved run of given steps continues exactly
template <class M, class System>
concept Method = requires(M& method, const M& constant, System& system, typename System::Scalar& t,
                          StateVector<typename System::Scalar>& y, const typename System::Scalar& stop) {
  method.step(system, t, y, stop);
  method.restart();
  { method.shorten() } -> std::same_as<bool>;
  { constant.counters() } -> std::same_as<const Counters&>;
};

}  // namespace trivium::integrators
