#pragma once
/// The entry of a method in the list: its name, what it is and takes, and how it is made. An entry is all
/// that a new method needs besides its own file: names on the command line, checks of steps and parameters,
/// and the studies of convergence follow from it.

#include <memory>
#include <optional>
#include <string_view>

#include "integrators/contract/any_method.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/method_parameters.hpp"

namespace trivium::integrators {

struct MethodInfo {
  std::string_view name, summary;
  int order = 0;  ///< of positions, velocities and lambda at given steps; 0: it varies
  bool takes_given_steps = false, chooses_steps = false;
  bool meets_constraints = false;           ///< of positions, by its own equations: it is not projected
  bool needs_constant_inertia = false;      ///< a mass matrix that does not depend on positions
  bool has_own_lambda = meets_constraints;  ///< beside that of a state
  int own_lambda_order = order;             ///< of that, at given steps
  // which of MethodParameters it takes
  bool takes_order = false, takes_rho = false, takes_alpha = false, takes_full_newton = false;
};

/// What a method is made for. Which steps and parameters it takes has been checked.
struct MethodRequest {
  std::optional<Tolerances> tolerances;  ///< absent: steps of the grid's length
  MethodParameters given;
};

template <class S>
struct MethodEntry {
  MethodInfo info;
  /// Throws a UsageError where a parameter is out of its range.
  std::unique_ptr<AnyMethod<S>> (*make)(const MethodRequest&);
};

}  // namespace trivium::integrators
