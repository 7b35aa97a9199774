#pragma once
/// Steps taken again as two steps of half the length. If a method has order p, two half steps have an error
/// 2^-p times that of the whole step, so that the difference of their ends is the error of the whole step.

#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

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

  /// Whether the step number `step` is to be taken in halves. `errors` of each body tell how large its errors
  /// are, in units of the caller. Their sums are decided where they are largest: a step is taken if the
  /// errors of a body are far larger than in all steps taken so far, which happens a few times, and otherwise
  /// one of 120 or more, the sooner the larger its errors are. So this costs less than a twentieth of a run.
  bool is_due(const std::vector<std::pair<S, S>>& errors, long step) {
    constexpr double far_larger = 6;
    constexpr long wait = 120;
    const long waited = step - last_;
    const double nearly = waited < wait ? 0 : std::scalbln(1.0, waited / wait);
    largest_.resize(errors.size(), {S(0), S(0)});
    bool is = false;
    const auto compare = [&](const S& error, const S& largest) {
      is = is || error > far_larger * largest || (nearly > 0 && error > S(0) && nearly * error >= largest);
    };
    for (std::size_t b = 0; b < errors.size(); ++b) {
      compare(errors[b].first, largest_[b].first);
      compare(errors[b].second, largest_[b].second);
    }
    if (!is) return false;
    for (std::size_t b = 0; b < errors.size(); ++b) {
      raise(largest_[b].first, errors[b].first);
      raise(largest_[b].second, errors[b].second);
    }
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
  std::vector<std::pair<S, S>> largest_;  ///< errors of each body in the steps taken so far
  long last_ = 0;
};

}  // namespace trivium
