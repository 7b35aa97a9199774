#include "integrators/implicit/methods.hpp"

#include "integrators/implicit/bdf.hpp"
#include "integrators/implicit/generalized_alpha.hpp"
#include "integrators/implicit/hht.hpp"
#include "integrators/implicit/radau.hpp"
#include "integrators/quad.hpp"

namespace trivium::integrators {

namespace {

template <class Value>
Value checked(const char* what, const std::optional<Value>& given, Value standard, Value least, Value most) {
  const Value value = given.value_or(standard);
  if (!(value >= least && value <= most))
    throw UsageError(fmt::format("{} {}; accepted: {:.4g} to {:.4g}", what, value, static_cast<double>(least),
                                 static_cast<double>(most)));
  return value;
}

}  // namespace

template <class S>
std::unique_ptr<AnyMethod<S>> make_implicit(std::string_view name,
                                            const std::optional<Tolerances>& tolerances,
                                            const MethodParameters& given) {
  NewtonOptions newton;
  newton.is_full = given.full_newton.value_or(false);
  if (name.starts_with("generalized-alpha"))
    return adapt<S>(GeneralizedAlpha<AnySystem<S>>(checked("rho", given.rho, 0.8, 0.0, 1.0),
                                                   name.ends_with("gl2"), newton));
  if (name == "hht")
    return adapt<S>(HHT<AnySystem<S>>(checked("alpha", given.alpha, -0.2, -1.0 / 3, 0.0), newton));
  if (name == "radau5") return adapt<S>(Radau5<AnySystem<S>>(tolerances, newton));
  if (name == "radau9") return adapt<S>(Radau9<AnySystem<S>>(tolerances, newton));
  if (name == "bdf")
    return adapt<S>(BDF<AnySystem<S>>(checked("an order of bdf of", given.order, 2, 1, 5), newton));
  return nullptr;
}

template std::unique_ptr<AnyMethod<double>> make_implicit<double>(std::string_view,
                                                                  const std::optional<Tolerances>&,
                                                                  const MethodParameters&);
template std::unique_ptr<AnyMethod<Quad>> make_implicit<Quad>(std::string_view,
                                                              const std::optional<Tolerances>&,
                                                              const MethodParameters&);

}  // namespace trivium::integrators
