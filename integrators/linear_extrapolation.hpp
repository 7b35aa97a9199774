#pragma once
/// Linear extrapolation: the start value of an implicit step's iteration, from a quantity's last two values.
/// A good start value shortens the iteration; the solution of the step does not depend on it.

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// A quantity at the ends of the last two steps.
template <class S>
class LinearExtrapolation {
 public:
  /// Sets the two values at the start: `value`, and `value` less h times its rate.
  void begin(const StateVector<S>& value, const StateVector<S>& rate, const S& h) {
    now_ = value;
    before_ = value - h * rate;
  }
  const StateVector<S>& now() const { return now_; }
  /// Sets `value` to the extrapolated one at a time ahead of now; `steps` is this time divided by the length
  /// of the last step [-].
  void ahead(const S& steps, StateVector<S>& value) const { value = now_ + steps * (now_ - before_); }
  void show_memory(auto&& show) { show(now_, before_); }
  /// Adds the value at the end of a step.
  void push(const StateVector<S>& value) {
    before_.swap(now_);
    now_ = value;
  }

 private:
  StateVector<S> now_, before_;
};

}  // namespace trivium::integrators
