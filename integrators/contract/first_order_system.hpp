#pragma once
/// The smallest contract of a model: y' = f(t, y) for a y on the constraint manifold, and corrections that
/// lead back to this manifold. Explicit methods need no more. The contract does not depend on formulations or
/// scenes.

#include <concepts>
#include <string>

#include "base/raise.hpp"
#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// The constraint violation at a state. `size` is the largest violation of a row, in the units of the model.
/// `relative` [-] is the largest violation relative to the numbers that the row is computed from. Rounding
/// alone leaves a few unit roundoffs. `row` is the row with the largest relative violation, -1 if there are
/// no rows.
template <class S>
struct Violation {
  S size{0}, relative{0};
  int row = -1;
};

/// A relative violation above this is an error, and no rounding, also where a row is not solved for. The
/// value is chosen by experiment: singular positions leave less, and projections that start too far away
/// leave more.
constexpr double most_violation = 1e-6;

using trivium::raise;
/// Keeps the violation with the larger relative value; a NaN stays.
template <class S>
void raise(Violation<S>& largest, const Violation<S>& next) {
  if (!(next.relative <= largest.relative) && largest.relative == largest.relative) largest = next;
}

/// The equations:
///
///   size, start          the number of elements of y, and y at the start
///   derivative           from (t, y, y'): computes y' at (t, y). Throws a std::runtime_error if y is not a
///                        possible state. A method that chooses its steps then tries a smaller one
///                        (arkode-erk ends the run); a run with given steps ends
///   longest_step         the longest step from (t, y) that the model allows [s]
///
/// The constraints:
///
///   position_violation   the Violation of the position constraints at (t, y)
///   velocity_violation   the Violation of the velocity constraints at (t, y)
///   row_name             the name of a row, for its number
///   correct_positions    from (t, y, factor): one Newton correction of the positions. If `factor`, the
///                        matrix is factored at y; otherwise the last factors are used
///   correct_velocities   the same for the velocities. Both share their factors: with `factor` false,
///                        those of the last call of either with `factor` true are used
///   normalise            changes y so that it satisfies the internal rows, such as |p| = 1
///
/// Decisions of the system that integrate.hpp asks for and acts on:
///
///   projection_is_too_large
///                        from (before, stepped, projected): whether the projection of a step is so large
///                        that the step may have left its branch. The threshold is the system's
///                        (simulation/system/branch_check.hpp). If the answer is yes, checked_step in
///                        integrate.cpp asks the method for a shorter step
///   accept_state         receives every state that the motion has reached, after its projection. Returns
///                        whether the coordinates of y have changed (re-framing); the method's memory is then
///                        invalid
///   pass_discontinuity   from (before, t, y): moves y over a time t at which the model may jump; `before` is
///                        the time just before t. Returns whether y jumped
///   most_accelerated     a clause for messages: which body has the largest acceleration at (t, y)
///   diagnose             from (t, y, h): a property of the model that may have made a step of length h from
///                        (t, y) fail, as a text; empty if there is none. h = 0 if the step chose its length
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
  { system.diagnose(t, y, t) } -> std::convertible_to<std::string>;
  { system.most_accelerated(t, y) } -> std::convertible_to<std::string>;
};

}  // namespace trivium::integrators
