#include "integrators/methods.hpp"

#include <boost/multiprecision/float128.hpp>

#include "integrators/odeint.hpp"

namespace trivium::integrators {

namespace {

template <class S, class M>
std::unique_ptr<AnyMethod<S>> erase(M method) {
  return std::make_unique<ErasedMethod<S, M>>(std::move(method));
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

}  // namespace

const std::vector<MethodInfo>& methods() {
  static const std::vector<MethodInfo> all{
      {"dopri5", "Dormand-Prince 5(4), explicit Runge-Kutta (Odeint)", 5, true},
      {"rkf78", "Fehlberg 7(8), explicit Runge-Kutta (Odeint)", 8, true},
      {"bulirsch-stoer", "Bulirsch-Stoer extrapolation, orders 4 to 16 (Odeint)", 0, false},
      {"abm", "Adams-Bashforth-Moulton, multistep, orders 1 to 12, at given steps 5 (Odeint)", 5, true},
  };
  return all;
}

const MethodInfo* find_method(std::string_view name) {
  for (const MethodInfo& method : methods())
    if (method.name == name) return &method;
  return nullptr;
}

template <class S>
std::unique_ptr<AnyMethod<S>> make_method(std::string_view name, Steps steps, const Tolerances& tolerances) {
  const bool chosen = steps == Steps::chosen;
  if (name == "dopri5")
    return chosen ? chosen_runge_kutta<S, DormandPrince5<S>>(5, tolerances)
                  : erase<S>(GivenSteps<S, DormandPrince5<S>>());
  if (name == "rkf78")
    return chosen ? chosen_runge_kutta<S, Fehlberg78<S>>(8, tolerances)
                  : erase<S>(GivenSteps<S, Fehlberg78<S>>());
  if (name == "bulirsch-stoer") {
    if (!chosen)
      throw UsageError(
          "bulirsch-stoer chooses its orders and steps by tolerances and takes no given step; give it rtol "
          "and "
          "atol, or take dopri5, rkf78 or abm");
    return erase<S>(ChosenSteps<S, BulirschStoer<S>>(BulirschStoer<S>(S(tolerances.atol), S(tolerances.rtol)),
                                                     8, tolerances));
  }
  if (name == "abm") {
    if (!chosen) return erase<S>(GivenSteps<S, AdamsBashforthMoulton<S>>());
    if constexpr (std::is_same_v<S, double>)
      return chosen_adams(tolerances);
    else
      throw UsageError("abm chooses its steps in double alone (Odeint's choice does); give it a step");
  }
  throw UsageError(fmt::format("there is no method \"{}\"", name));
}

using Quad =
    boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

template std::unique_ptr<AnyMethod<double>> make_method<double>(std::string_view, Steps, const Tolerances&);
template std::unique_ptr<AnyMethod<Quad>> make_method<Quad>(std::string_view, Steps, const Tolerances&);

}  // namespace trivium::integrators
