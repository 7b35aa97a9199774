#pragma once
/// The choice between given and chosen steps for methods without an error estimate of their own. Without
/// tolerances such a method takes given steps; with them ErrorControl chooses its steps.

#include <memory>
#include <utility>

#include "integrators/error_control.hpp"
#include "integrators/method_entry.hpp"

namespace trivium::integrators {

/// The method with given steps, or with steps that ErrorControl chooses; `order` is the method's. A step is
/// at most `most_growth` times as long as the one before: BDF is unstable beyond its limit (bdf.hpp), and
/// the weights of the estimate grow if its past states lie close together beside the step.
template <class S, class M>
std::unique_ptr<AnyMethod<S>> with_steps(const MethodRequest& request, int order, M method,
                                         double most_growth = 2) {
  if (!request.tolerances) return adapt<S>(std::move(method));
  return adapt<S>(ErrorControl<M, AnySystem<S>>(std::move(method), order, *request.tolerances, most_growth));
}

}  // namespace trivium::integrators
