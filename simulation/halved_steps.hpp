#pragma once
/// Steps taken again as two steps of half the length. If a method has order p, two half steps have an error
/// 2^-p times that of the whole step, so that the difference of their ends is the error of the whole step.

#include <memory>
#include <stdexcept>
#include <utility>

#include "integrators/contract/any_method.hpp"
#include "integrators/projection_iteration.hpp"

namespace trivium {

/// Takes steps in two halves by a method object of its own, beside the run, which does not notice it. The
/// estimate is meant for methods that remember no earlier steps.
template <class S>
class HalvedSteps {
 public:
  using StateVector = integrators::StateVector<S>;

  /// `system` must outlive this object. `projects`: whether steps end with a projection.
  HalvedSteps(integrators::AnySystem<S>& system, std::unique_ptr<integrators::AnyMethod<S>> method,
              bool projects)
      : system_(system), method_(std::move(method)), projects_(projects) {}

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
  const integrators::Counters& counters() const { return method_->counters(); }

 private:
  integrators::AnySystem<S>& system_;
  std::unique_ptr<integrators::AnyMethod<S>> method_;
  bool projects_;
  integrators::ProjectionIteration<integrators::AnySystem<S>> project_;
};

}  // namespace trivium
