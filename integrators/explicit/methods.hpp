#pragma once
/// The explicit and half-explicit methods of the list. To add a method, add an entry in methods.cpp.

#include <vector>

#include "integrators/method_entry.hpp"

namespace trivium::integrators {

/// The entries of the explicit and half-explicit methods.
template <class S>
std::vector<MethodEntry<S>> explicit_methods();

}  // namespace trivium::integrators
