#pragma once
/// The implicit methods of the list. To add a method, add an entry in methods_impl.hpp.

#include <vector>

#include "integrators/method_entry.hpp"

namespace trivium::integrators {

/// The entries of the implicit methods.
template <class S>
std::vector<MethodEntry<S>> implicit_methods();

}  // namespace trivium::integrators
