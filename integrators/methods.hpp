#pragma once
/// The methods by name.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "integrators/erased.hpp"

namespace trivium::integrators {

/// Where a method's steps come from.
enum class Steps { given, chosen };

struct MethodInfo {
  std::string_view name, summary;
  int order;  ///< of positions, velocities and lambda at given steps; 0: it varies
  bool takes_given_steps;
};

/// In the order they are listed in.
const std::vector<MethodInfo>& methods();

/// Null where there is none of this name.
const MethodInfo* find_method(std::string_view name);

/// The method, with steps of its own choice to the tolerances, or of the grid's length. Throws a
/// UsageError where it cannot take given steps.
template <class S>
std::unique_ptr<AnyMethod<S>> make_method(std::string_view name, Steps steps, const Tolerances& tolerances);

}  // namespace trivium::integrators
