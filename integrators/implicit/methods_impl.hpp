#pragma once
/// The one definition behind make_implicit: an implicit method by its name, its parameters checked. One
/// translation unit a Scalar.

#include <fmt/format.h>

#include "integrators/implicit/bdf.hpp"
#include "integrators/implicit/generalized_alpha.hpp"
#include "integrators/implicit/hht.hpp"
#include "integrators/implicit/methods.hpp"
#include "integrators/implicit/radau.hpp"

namespace trivium::integrators {

namespace detail {

template <class Value>
Value checked(const char* what, const std::optional<Value>& given, Value standard, Value least, Value most) {
  const Value value = given.value_or(standard);
  if (!(value >= least && value <= most))
    throw UsageError(fmt::format("{} {}; accepted: {:.4g} to {:.4g}", what, value, static_cast<double>(least),
                                 static_cast<double>(most)));
  return value;
}

}  // namespace detail

template <class S>
std::unique_ptr<AnyMethod<S>> make_implicit(std::string_view name,
                                            const std::optional<Tolerances>& tolerances,
                                            const MethodParameters& given) {
  NewtonOptions newton;
  newton.is_full = given.full_newton.value_or(false);
  if (name.starts_with("generalized-alpha"))
    return adapt<S>(GeneralizedAlpha<AnySystem<S>>(detail::checked("rho", given.rho, 0.8, 0.0, 1.0),
                                                   name.ends_with("gl2"), newton));
  if (name == "hht")
    return adapt<S>(HHT<AnySystem<S>>(detail::checked("alpha", given.alpha, -0.2, -1.0 / 3, 0.0), newton));
  if (name == "radau5") return adapt<S>(Radau5<AnySystem<S>>(tolerances, newton));
  if (name == "radau9") return adapt<S>(Radau9<AnySystem<S>>(tolerances, newton));
  if (name == "bdf")
    return adapt<S>(BDF<AnySystem<S>>(detail::checked("an order of bdf of", given.order, 2, 1, 5), newton));
  return nullptr;
}

}  // namespace trivium::integrators
