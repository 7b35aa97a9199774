#pragma once
/// The work that methods of order 2 add up beside the motion, by trapezoids. Methods of higher order
/// integrate it as one more number of y.

#include <utility>

#include "integrators/contract/residual.hpp"

namespace trivium::integrators {

/// The work behind q and v in y, where a system has it: by trapezoids, of order 2.
template <class S>
class WorkQuadrature {
 public:
  void begin(const S& rate) { rate_ = rate; }
  void show_memory(auto&& show) { show(rate_); }
  /// Over a step of h to y, where the system is evaluated.
  template <HasResidual System>
  void add(System& system, const typename System::Evaluation& at, const StateVector<S>& lambda, const S& h,
           StateVector<S>& y) {
    const int motion = system.position_size() + system.velocity_size();
    if (y.size() > motion) add(S(system.work_rate(at, lambda)), h, y[motion]);
  }
  /// Over a step of h to where this is its rate.
  void add(const S& rate, const S& h, S& work) {
    const S before = std::exchange(rate_, rate);
    work += h * (before + rate_) / 2;
  }

 private:
  S rate_{0};
};

}  // namespace trivium::integrators
