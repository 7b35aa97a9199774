#pragma once
/// The explicit and half-explicit methods by name. A method's parameters are checked where it is made.

#include <memory>
#include <optional>
#include <string_view>

#include "integrators/contract/any_method.hpp"
#include "integrators/contract/tolerances.hpp"

namespace trivium::integrators {

/// With steps chosen to the tolerances, or of the grid's length where there are none. Null where none of
/// these methods has the name.
template <class S>
std::unique_ptr<AnyMethod<S>> make_explicit(std::string_view name,
                                            const std::optional<Tolerances>& tolerances);

}  // namespace trivium::integrators
