#pragma once
/// The symplectic methods by name. A method's parameters are checked where it is made.

#include <memory>
#include <string_view>

#include "integrators/contract/any_method.hpp"

namespace trivium::integrators {

/// With steps of the grid's length. Null where none of these methods has the name.
template <class S>
std::unique_ptr<AnyMethod<S>> make_symplectic(std::string_view name);

}  // namespace trivium::integrators
