#pragma once
/// What integrators ask of a model: concepts, and nothing of formulations or scenes.

#include <Eigen/Core>
#include <concepts>
#include <stdexcept>
#include <string>

namespace trivium::integrators {

template <class S>
using Flat = Eigen::Matrix<S, Eigen::Dynamic, 1>;

/// y' = f(t, y), y on the manifold that constraints leave.
///
/// `derivative` may throw a std::runtime_error where y makes no sense; a method then takes a smaller step.
/// A violation is the largest distance from a constraint, in units of the model; `relative_violation` is the
/// one measured last beside the model's own numbers, so that rounding is some u. `correct_...` is one step of
/// the way back from there, by a matrix factored there or, unless `factor`, before. `strays` is asked whether
/// a projection went too far to be one, `longest_step` how long a step from a state may be for reasons of the
/// model. `settle` is told every state that the motion has reached, projected; it returns whether y is in
/// other coordinates since, so that what a method remembers of it is void.
template <class System>
concept FirstOrderSystem = requires(System& system, const typename System::Scalar& t,
                                    const Flat<typename System::Scalar>& y,
                                    Flat<typename System::Scalar>& changed, int index, bool factor) {
  { system.size() } -> std::convertible_to<int>;
  { system.start() } -> std::convertible_to<Flat<typename System::Scalar>>;
  system.derivative(t, y, changed);
  { system.position_violation(t, y) } -> std::convertible_to<typename System::Scalar>;
  { system.velocity_violation(t, y) } -> std::convertible_to<typename System::Scalar>;
  { system.relative_violation() } -> std::convertible_to<typename System::Scalar>;
  { system.strays(y, y, y) } -> std::same_as<bool>;
  { system.longest_step(t, y) } -> std::convertible_to<typename System::Scalar>;
  system.correct_positions(changed, factor);
  system.correct_velocities(changed, factor);
  system.meet_internal(changed);
  { system.worst_row() } -> std::convertible_to<std::string>;
  { system.settle(t, changed) } -> std::same_as<bool>;
  { system.suspect(t, y) } -> std::convertible_to<std::string>;
};

/// A method gave up: says at what time, why, and what to try.
class IntegrationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What was asked for cannot be: times that do not fit together, a method with steps that it does not take.
class UsageError : public IntegrationError {
 public:
  using IntegrationError::IntegrationError;
};

/// What a method may miss: errors of each number up to atol + rtol |number|, per step.
struct Tolerances {
  double rtol = 1e-8, atol = 1e-10;
};

/// What a method has done.
struct Counters {
  long steps = 0, rejected_steps = 0, right_sides = 0, restarts = 0;
};

}  // namespace trivium::integrators
