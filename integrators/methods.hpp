#pragma once
/// The methods by name.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "integrators/contract/any_method.hpp"
#include "integrators/integrate.hpp"

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

/// What some methods let one choose; absent: the default that is named.
struct MethodParameters {
  std::optional<int> order = {};   ///< of bdf, 1 to 5: 2; of arkode-erk, 2 to 8, and arkode-dirk, 2 to 5: 5
  std::optional<double> rho = {};  ///< of generalized-alpha, in [0, 1]: 0.8, the spectral radius at infinity
  std::optional<double> alpha = {};  ///< of hht, in [-1/3, 0]: -0.2
  std::optional<bool> full_newton =
      {};                ///< of Newton's methods of our own: a matrix every iteration, not every step
  bool projects = true;  ///< whether states are projected, of cvode-bdf, which does so within its steps
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
