#pragma once
/// What an implicit step begins its iteration with: the line through a quantity's last two values. It only
/// shortens the iteration; the step's solution does not depend on it.

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// A quantity at the ends of the last two steps, and on along the line through them.
template <class S>
class LinearExtrapolation {
 public:
  void begin(const StateVector<S>& value, const StateVector<S>& rate, const S& h) {
    now_ = value;
    before_ = value - h * rate;
  }
  const StateVector<S>& now() const { return now_; }
  /// So many of the last step's lengths ahead.
  void ahead(const S& steps, StateVector<S>& value) const { value = now_ + steps * (now_ - before_); }
  void show_memory(auto&& show) { show(now_, before_); }
  void push(const StateVector<S>& value) {
    before_.swap(now_);
    now_ = value;
  }

 private:
  StateVector<S> now_, before_;
};

}  // namespace trivium::integrators
