#pragma once
/// The symplectic methods of the list. To add a method, add an entry in methods.cpp.

#include <vector>

#include "integrators/method_entry.hpp"

namespace trivium::integrators {

/// The entries of the symplectic methods.
template <class S>
std::vector<MethodEntry<S>> symplectic_methods();

}  // namespace trivium::integrators
