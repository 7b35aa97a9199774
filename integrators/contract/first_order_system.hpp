#pragma once
/// The least that integrators ask of a model: y' = f(t, y), with y on the manifold that constraints leave,
/// and the way back onto that manifold. Explicit methods need no more. Nothing here knows of formulations or
/// scenes.

#include <concepts>
#include <string>

#include "base/raise.hpp"
#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// How far y is from the constraints: the largest distance from one of them, in units of the model; the
/// largest beside the model's own numbers, where rounding is a few units of roundoff; and the row that is
/// farthest off, -1 if there is none.
template <class S>
struct Violation {
  S size{0}, relative{0};
  int row = -1;
};

using trivium::raise;
/// By the relative one.
template <class S>
void raise(Violation<S>& largest, const Violation<S>& next) {
  if (!(next.relative <= largest.relative) && largest.relative == largest.relative) largest = next;
}

/// The equations:
///
///   size, start          how many numbers y has, and which it has at the start
///   derivative           y' at (t, y). Throws a std::runtime_error where y makes no sense; the method then
///                        takes a smaller step
///   longest_step         how long a step from (t, y) may be, for reasons of the model
///
/// The constraints:
///
///   position_violation   the Violation of the constraints on positions at (t, y)
///   velocity_violation   of those on velocities
///   row_name             of a row by its number
///   correct_positions    from (t, y, factor): one Newton correction of y, by a matrix that is factored there
///                        or, unless `factor`, was factored before
///   correct_velocities   the same of velocities
///   normalise            meets the rows that a model keeps to itself, such as |p| = 1
///
/// Decisions of the system, which integrate.hpp asks for and acts on:
///
///   projection_is_too_large
///                        from (before, stepped, projected): whether the projection of a step went so far
///                        that the step may have left its branch. The threshold is the system's
///                        (simulation/system/branch_check.hpp); checked_step of integrate.cpp then
///                        has a shorter step taken
///   accept_state         is told every state that the motion has reached, projected. Returns whether y is in
///                        other coordinates since: what a method remembers of y is void then
///   pass_discontinuity   from (before, t, y): goes over a time t where the model may jump, from just before
///                        it. Returns whether y jumped
///   diagnose             what of the model may have made steps fail near (t, y); empty where nothing stands
///                        out
template <class System>
concept FirstOrderSystem = requires(System& system, const typename System::Scalar& t,
                                    const StateVector<typename System::Scalar>& y,
                                    StateVector<typename System::Scalar>& changed, bool factor, int row) {
  { system.size() } -> std::convertible_to<int>;
  { system.start() } -> std::convertible_to<StateVector<typename System::Scalar>>;
  system.derivative(t, y, changed);
  { system.position_violation(t, y) } -> std::same_as<Violation<typename System::Scalar>>;
  { system.velocity_violation(t, y) } -> std::same_as<Violation<typename System::Scalar>>;
  { system.row_name(row) } -> std::convertible_to<std::string>;
  { system.projection_is_too_large(y, y, y) } -> std::same_as<bool>;
  { system.longest_step(t, y) } -> std::convertible_to<typename System::Scalar>;
  system.correct_positions(t, changed, factor);
  system.correct_velocities(t, changed, factor);
  system.normalise(changed);
  { system.accept_state(t, changed) } -> std::same_as<bool>;
  { system.pass_discontinuity(t, t, changed) } -> std::same_as<bool>;
  { system.diagnose(t, y) } -> std::convertible_to<std::string>;
};

}  // namespace trivium::integrators
