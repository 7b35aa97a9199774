#pragma once
/// The choice between given and chosen steps for methods without an error estimate of their own. Without
/// tolerances such a method takes given steps; with them ErrorControl chooses its steps.

#include <memory>
#include <utility>

#include "integrators/error_control.hpp"
#include "integrators/method_entry.hpp"

namespace trivium::integrators {

/// The method with given steps, or with steps that ErrorControl chooses; `order` is the method's.
template <class S, class M>
std::unique_ptr<AnyMethod<S>> with_steps(const MethodRequest& request, int order, M method) {
  if (!request.tolerances) return adapt<S>(std::move(method));
  return adapt<S>(ErrorControl<M, AnySystem<S>>(std::move(method), order, *request.tolerances));
}

}  // namespace trivium::integrators
