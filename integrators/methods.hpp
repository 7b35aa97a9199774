#pragma once
/// The methods by name. The one list is put together of the entries of each kind, which stand in
/// {explicit,symplectic,sundials}/methods.cpp and implicit/methods_impl.hpp.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "integrators/method_entry.hpp"

namespace trivium::integrators {

/// Where a method's steps come from.
enum class Steps { given, chosen };

/// In the order they are listed in.
const std::vector<MethodInfo>& methods();
std::vector<std::string> method_names();

/// Null where there is none of this name.
const MethodInfo* find_method(std::string_view name);

/// The entry of this name. Throws a UsageError where there is none in S.
template <class S>
const MethodEntry<S>& method_entry(std::string_view name);

/// The method, with steps of its own choice to the tolerances, or of the grid's length. Throws a UsageError
/// where it takes no such steps, has no such parameter, or tolerances are below the rounding of S.
template <class S>
std::unique_ptr<AnyMethod<S>> make_method(const MethodEntry<S>& method, Steps steps,
                                          const Tolerances& tolerances,
                                          const MethodParameters& parameters = {});
template <class S>
std::unique_ptr<AnyMethod<S>> make_method(std::string_view name, Steps steps, const Tolerances& tolerances,
                                          const MethodParameters& parameters = {});

}  // namespace trivium::integrators
