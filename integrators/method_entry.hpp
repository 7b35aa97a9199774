#pragma once
/// The entry of a method in the list: its name, its properties and a function that makes it. A new method
/// needs such an entry and its own file, and nothing else. Names on the command line, checks of steps and
/// parameters, and the convergence studies follow from the entry.

#include <memory>
#include <optional>
#include <string_view>

#include "integrators/contract/any_method.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/method_parameters.hpp"

namespace trivium::integrators {

/// The properties of a method. Programs, checks and tests decide by them.
struct MethodInfo {
  std::string_view name, summary;
  int order = 0;               ///< order of positions, velocities and lambda at given steps; 0: it varies
  int standard_order = order;  ///< order that is used if the parameter `order` is left out
  bool takes_given_steps = false, chooses_steps = false;  ///< the kinds of steps that the method supports
  bool meets_constraints = false;           ///< satisfies Phi = 0 by its own equations; is not projected
  bool needs_constant_inertia = false;      ///< needs a mass matrix M that does not depend on q
  bool has_raw_lambda = meets_constraints;  ///< computes multipliers together with its step
  int raw_lambda_order = order;             ///< order of these multipliers at given steps
  // whether the method accepts each of the MethodParameters
  bool takes_order = false, takes_rho = false, takes_alpha = false, takes_full_newton = false;
};

/// The request for a method. Its kind of steps and its parameters have been checked against the MethodInfo.
struct MethodRequest {
  std::optional<Tolerances> tolerances;  ///< absent: the method takes given steps
  MethodParameters given;
};

/// A method of the list, in the scalar S.
template <class S>
struct MethodEntry {
  MethodInfo info;
  /// Makes the method. Throws a UsageError if a parameter is out of its range.
  std::unique_ptr<AnyMethod<S>> (*make)(const MethodRequest&);
};

}  // namespace trivium::integrators
