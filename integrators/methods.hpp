#pragma once
/// The methods by name: what each is and takes. Which class a name leads to is said by kind, in
/// {explicit,implicit,symplectic,sundials}/methods.cpp.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "integrators/contract/any_method.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/method_parameters.hpp"

namespace trivium::integrators {

/// Where a method's steps come from.
enum class Steps { given, chosen };

struct MethodInfo {
  std::string_view name, summary;
  int order;  ///< of positions, velocities and lambda at given steps; 0: it varies
  bool takes_given_steps, chooses_steps;
  bool meets_constraints;                   ///< of positions, by its own equations: it is not projected
  bool has_own_lambda = meets_constraints;  ///< beside that of a state
};

/// In the order they are listed in.
const std::vector<MethodInfo>& methods();
std::vector<std::string> method_names();

/// Null where there is none of this name.
const MethodInfo* find_method(std::string_view name);

/// The method, with steps of its own choice to the tolerances, or of the grid's length. Throws a UsageError
/// where it takes no such steps, has no such parameter, or tolerances are below the rounding of S.
template <class S>
std::unique_ptr<AnyMethod<S>> make_method(std::string_view name, Steps steps, const Tolerances& tolerances,
                                          const MethodParameters& parameters = {});

}  // namespace trivium::integrators
