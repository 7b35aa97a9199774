#pragma once
/// The work in generalised-alpha, HHT and every step of RATTLE, also those of its compositions, by the
/// trapezoidal rule. The other methods integrate the work as one more element of y.

#include <utility>

#include "integrators/contract/residual.hpp"

namespace trivium::integrators {

/// Adds up the work, the element of y after q and v, with order 2. Does nothing for a system without work.
template <class S>
class WorkQuadrature {
 public:
  void begin(const S& rate) { rate_ = rate; }  ///< `rate`: that of the work at the start [W]
  void show_memory(auto&& show) { show(rate_); }
  /// Adds the work of a step of size h that ends at the evaluation `at`, with these multipliers.
  template <HasResidual System>
  void add(System& system, const typename System::Evaluation& at, const StateVector<S>& lambda, const S& h,
           StateVector<S>& y) {
    const int motion = system.position_size() + system.velocity_size();
    if (y.size() > motion) add(S(system.work_rate(at, lambda)), h, y[motion]);
  }
  /// Adds the work of a step of size h at whose end the rate of the work is `rate`.
  void add(const S& rate, const S& h, S& work) {
    const S before = std::exchange(rate_, rate);
    work += h * (before + rate_) / 2;
  }

 private:
  S rate_{0};
};

}  // namespace trivium::integrators
