#pragma once
/// The list of methods by name, and how a method is made. The entries are written in
/// {explicit,symplectic,sundials}/methods.cpp and implicit/methods_impl.hpp, and put together into one list
/// here.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "integrators/method_entry.hpp"

namespace trivium::integrators {

/// The source of a method's step sizes: given by the user, or chosen by the method to meet tolerances.
enum class Steps { given, chosen };

/// All methods, in the order of the printed list.
const std::vector<MethodInfo>& methods();
/// Their names, in the same order.
std::vector<std::string> method_names();

/// The properties of the method with this name. Null if there is no method of this name.
const MethodInfo* find_method(std::string_view name);

/// The entry of this name. Throws a UsageError if there is none, or if the method does not compute in the
/// scalar S.
template <class S>
const MethodEntry<S>& method_entry(std::string_view name);

/// Makes a method from its entry. The tolerances are used if the steps are chosen. Throws a UsageError if the
/// method does not take such steps or such a parameter, if a parameter is out of its range, or if both
/// tolerances are below the rounding of S.
template <class S>
std::unique_ptr<AnyMethod<S>> make_method(const MethodEntry<S>& method, Steps steps,
                                          const Tolerances& tolerances,
                                          const MethodParameters& parameters = {});
/// The same from the name of a method. Throws as method_entry does, too.
template <class S>
std::unique_ptr<AnyMethod<S>> make_method(std::string_view name, Steps steps, const Tolerances& tolerances,
                                          const MethodParameters& parameters = {});

}  // namespace trivium::integrators
