#pragma once
/// Steps taken again as two steps of half the length. If a method has order p, two half steps have an error
/// 2^-p times that of the whole step, so that the difference of their ends is the error of the whole step.

#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "base/raise.hpp"
#include "integrators/contract/any_method.hpp"
#include "integrators/projection_iteration.hpp"

namespace trivium {

/// Takes steps in two halves by a method object of its own, beside the run, which does not notice it. The
/// estimate is meant for methods of a high order, which remember no earlier steps.
template <class S>
class HalvedSteps {
 public:
  using StateVector = integrators::StateVector<S>;

  /// `system` must outlive this object. `projects`: whether steps end with a projection.
  HalvedSteps(integrators::AnySystem<S>& system, std::unique_ptr<integrators::AnyMethod<S>> method,
              bool projects)
      : system_(system), method_(std::move(method)), projects_(projects) {}

  /// Whether a step is to be taken in halves; `position` and `velocity` tell how large its errors are, in
  /// units of the caller, `step` is its number. Their sums are decided where they are largest: steps with far
  /// larger errors than those taken so far are taken, which are few, and otherwise one of 120 or more, the
  /// sooner the larger its errors are. So this costs less than a twentieth of a run.
  bool is_due(double position, double velocity, long step) {
    constexpr double far_larger = 4;
    constexpr long wait = 120;
    const long waited = step - last_;
    const auto is = [&](double error, double largest) {
      return error > far_larger * largest ||
             (waited >= wait && std::scalbln(error, waited / wait) >= largest);
    };
    if (!is(position, position_) && !is(velocity, velocity_)) return false;
    raise(position_, position);
    raise(velocity_, velocity);
    last_ = step;
    return true;
  }

  /// Moves y from `t` to `stop`. Returns false if a half step fails.
  bool operator()(const S& t, const S& stop, StateVector& y) {
    integrators::ProjectionReport<S> report;
    method_->restart();
    S at = t;
    try {
      for (const S& to : {S(t + (stop - t) / 2), stop}) {
        method_->step(system_, at, y, to);
        if (projects_) project_(system_, at, y, report);
      }
    } catch (const std::runtime_error&) {  // the whole step did not fail
      return false;
    }
    return y.allFinite();
  }

 private:
  integrators::AnySystem<S>& system_;
  std::unique_ptr<integrators::AnyMethod<S>> method_;
  bool projects_;
  integrators::ProjectionIteration<integrators::AnySystem<S>> project_;
  double position_ = 0, velocity_ = 0;  ///< the largest taken so far
  long last_ = 0;
};

}  // namespace trivium
