#include "integrators/methods.hpp"

#include <algorithm>
#include <boost/multiprecision/float128.hpp>
#include <initializer_list>
#include <limits>

#include "integrators/explicit/half_explicit.hpp"
#include "integrators/explicit/odeint.hpp"
#include "integrators/implicit/bdf.hpp"
#include "integrators/implicit/generalized_alpha.hpp"
#include "integrators/implicit/hht.hpp"
#include "integrators/implicit/radau.hpp"
#include "integrators/sundials/methods.hpp"
#include "integrators/symplectic/rattle.hpp"

namespace trivium::integrators {

namespace {

template <class S, class M>
std::unique_ptr<AnyMethod<S>> erase(M method) {
  return std::make_unique<MethodAdapter<S, M>>(std::move(method));
}

template <class S, class Stepper>
auto chosen_runge_kutta(int order, const Tolerances& tolerances) {
  using Controlled = odeint::controlled_runge_kutta<Stepper>;
  return erase<S>(ChosenSteps<S, Controlled>(
      Controlled(typename Controlled::error_checker_type(S(tolerances.atol), S(tolerances.rtol))), order,
      tolerances));
}

std::unique_ptr<AnyMethod<double>> chosen_adams(const Tolerances& tolerances) {
  using Controlled = odeint::controlled_adams_bashforth_moulton<AdaptiveAdams>;
  constexpr double no_limit = 1e300;
  return erase<double>(ChosenSteps<double, Controlled>(
      Controlled({tolerances.atol, tolerances.rtol, no_limit}), 1, tolerances));
}

/// Those that compute in double alone.
std::unique_ptr<AnyMethod<double>> of_a_library(std::string_view name, bool chosen,
                                                const Tolerances& tolerances, const MethodParameters& given) {
  if (name == "cvode-adams") return make_cvode_adams(tolerances);
  if (name == "cvode-bdf") return make_cvode_bdf(tolerances, given.projects);
  if (name == "ida") return make_ida(tolerances);
  if (name.starts_with("arkode")) {
    const bool is_implicit = name == "arkode-dirk";
    const int order = given.order.value_or(5);
    if (order < 2 || order > (is_implicit ? 5 : 8) || order == 7)
      throw UsageError(fmt::format("an order {} of {}; accepted: {}", order, name,
                                   is_implicit ? "2 to 5" : "2 to 6 and 8"));
    return make_arkode(is_implicit, order, chosen ? std::optional<Tolerances>(tolerances) : std::nullopt);
  }
  return chosen_adams(tolerances);
}

}  // namespace

const std::vector<MethodInfo>& methods() {
  static const std::vector<MethodInfo> all{
      {"dopri5", "Dormand-Prince 5(4), explicit Runge-Kutta (Odeint)", 5, true, true, false},
      {"rkf78", "Fehlberg 7(8), explicit Runge-Kutta (Odeint)", 8, true, true, false},
      {"bulirsch-stoer", "Bulirsch-Stoer extrapolation, orders 4 to 16 (Odeint)", 0, false, true, false},
      {"abm", "Adams-Bashforth-Moulton, multistep, orders 1 to 12, at given steps 5 (Odeint)", 5, true, true,
       false},
      {"hedop5", "half-explicit Dormand-Prince 5(4), index 2", 5, true, true, false, true},
      {"hem4", "half-explicit Runge-Kutta, index 2", 4, true, false, false, true},
      {"generalized-alpha", "generalised-alpha on Lie groups, index 3", 2, true, false, true},
      {"generalized-alpha-gl2", "generalised-alpha on Lie groups, stabilised index 2", 2, true, false, true},
      {"hht", "Hilber-Hughes-Taylor, index 3", 2, true, false, true},
      {"rattle", "RATTLE on Lie groups, symplectic, where M is constant", 2, true, false, true},
      {"rattle4", "RATTLE composed to order 4, symplectic, where M is constant", 4, true, false, true},
      {"radau5", "Radau IIA of 3 stages, stabilised index 2", 5, true, true, true},
      {"radau9", "Radau IIA of 5 stages, stabilised index 2", 9, true, true, true},
      {"bdf", "backward differentiation, orders 1 to 5, index 3", 0, true, false, true},
      {"cvode-adams", "Adams, orders 1 to 12 (CVODE)", 0, false, true, false},
      {"cvode-bdf", "backward differentiation, orders 1 to 5, projected within its steps (CVODE)", 0, false,
       true, false},
      {"arkode-erk", "explicit Runge-Kutta, of orders 2 to 8 (ARKODE)", 5, true, true, false},
      {"arkode-dirk", "diagonally implicit Runge-Kutta, of orders 2 to 5 (ARKODE)", 5, true, true, false},
      {"ida", "backward differentiation, orders 1 to 5, stabilised index 2 (IDA)", 0, false, true, true},
  };
  return all;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodInfo& method : methods()) names.emplace_back(method.name);
  return names;
}

const MethodInfo* find_method(std::string_view name) {
  for (const MethodInfo& method : methods())
    if (method.name == name) return &method;
  return nullptr;
}

namespace {

template <class Value>
Value checked(const char* what, const std::optional<Value>& given, Value standard, Value least, Value most) {
  const Value value = given.value_or(standard);
  if (!(value >= least && value <= most))
    throw UsageError(fmt::format("{} {}; accepted: {:.4g} to {:.4g}", what, value, static_cast<double>(least),
                                 static_cast<double>(most)));
  return value;
}

/// Throws where steps or parameters are none of the method's.
void check(const MethodInfo& method, Steps steps, const MethodParameters& given) {
  if (steps == Steps::given && !method.takes_given_steps)
    throw UsageError(
        fmt::format("{} chooses its steps by tolerances and takes no given step; give it rtol and atol, or "
                    "take another method",
                    method.name));
  if (steps == Steps::chosen && !method.chooses_steps)
    throw UsageError(fmt::format("{} takes steps of a given length; give it a step", method.name));
  const auto only = [&](bool is_given, const char* what, std::initializer_list<std::string_view> families) {
    if (!is_given) return;
    std::vector<std::string_view> names;
    for (const MethodInfo& one : methods())
      for (const std::string_view family : families)
        if (one.name.starts_with(family)) names.push_back(one.name);
    if (std::find(names.begin(), names.end(), method.name) == names.end())
      throw UsageError(fmt::format("{} is a parameter of {}, and {} has none such", what,
                                   fmt::join(names, ", "), method.name));
  };
  only(given.order.has_value(), "an order", {"bdf", "arkode-erk", "arkode-dirk"});
  only(given.rho.has_value(), "rho", {"generalized-alpha"});
  only(given.alpha.has_value(), "alpha", {"hht"});
  only(given.full_newton.has_value(), "a matrix for every iteration (full Newton)",
       {"generalized-alpha", "hht", "radau", "bdf"});
}

}  // namespace

template <class S>
std::unique_ptr<AnyMethod<S>> make_method(std::string_view name, Steps steps, const Tolerances& tolerances,
                                          const MethodParameters& given) {
  const MethodInfo* method = find_method(name);
  if (method == nullptr) throw UsageError(fmt::format("there is no method \"{}\"", name));
  check(*method, steps, given);
  const bool chosen = steps == Steps::chosen;
  if (const double u = static_cast<double>(std::numeric_limits<S>::epsilon());
      chosen && tolerances.rtol < 4 * u && tolerances.atol < 4 * u)
    throw UsageError(
        fmt::format("rtol {} and atol {} are below what rounding leaves of a step; accepted: at "
                    "least one of them from {:.1e} on",
                    tolerances.rtol, tolerances.atol, 4 * u));
  const std::optional<Tolerances> of_own_choice =
      chosen ? std::optional<Tolerances>(tolerances) : std::nullopt;
  NewtonOptions newton;
  newton.is_full = given.full_newton.value_or(false);
  if (name == "dopri5")
    return chosen ? chosen_runge_kutta<S, DormandPrince5<S>>(5, tolerances)
                  : erase<S>(GivenSteps<S, DormandPrince5<S>>());
  if (name == "rkf78")
    return chosen ? chosen_runge_kutta<S, Fehlberg78<S>>(8, tolerances)
                  : erase<S>(GivenSteps<S, Fehlberg78<S>>());
  if (name == "bulirsch-stoer")
    return erase<S>(ChosenSteps<S, BulirschStoer<S>>(BulirschStoer<S>(S(tolerances.atol), S(tolerances.rtol)),
                                                     8, tolerances));
  if (name.starts_with("generalized-alpha"))
    return erase<S>(GeneralizedAlpha<AnySystem<S>>(checked("rho", given.rho, 0.8, 0.0, 1.0),
                                                   name.ends_with("gl2"), newton));
  if (name.starts_with("rattle")) return erase<S>(Rattle<AnySystem<S>>(name == "rattle4" ? 4 : 2));
  if (name == "hem4") return erase<S>(HalfExplicit<AnySystem<S>, Hem4Coefficients<S>>());
  if (name == "hedop5") return erase<S>(HalfExplicit<AnySystem<S>, Hedop5Coefficients<S>>(of_own_choice));
  if (name == "hht")
    return erase<S>(HHT<AnySystem<S>>(checked("alpha", given.alpha, -0.2, -1.0 / 3, 0.0), newton));
  if (name == "radau5") return erase<S>(Radau5<AnySystem<S>>(of_own_choice, newton));
  if (name == "radau9") return erase<S>(Radau9<AnySystem<S>>(of_own_choice, newton));
  if (name == "bdf")
    return erase<S>(BDF<AnySystem<S>>(checked("an order of bdf of", given.order, 2, 1, 5), newton));
  if (name == "abm" && !chosen) return erase<S>(GivenSteps<S, AdamsBashforthMoulton<S>>());
  if constexpr (std::is_same_v<S, double>)
    return of_a_library(name, chosen, tolerances, given);
  else
    throw UsageError(
        name == "abm"
            ? std::string("abm chooses its steps in double alone (Odeint's choice does); give it a step")
            : fmt::format("{} computes in double alone (SUNDIALS does); take another method", name));
}

using Quad =
    boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

template std::unique_ptr<AnyMethod<double>> make_method<double>(std::string_view, Steps, const Tolerances&,
                                                                const MethodParameters&);
template std::unique_ptr<AnyMethod<Quad>> make_method<Quad>(std::string_view, Steps, const Tolerances&,
                                                            const MethodParameters&);

}  // namespace trivium::integrators
