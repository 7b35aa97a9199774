#include "integrators/explicit/methods.hpp"

#include <type_traits>
#include <utility>

#include "integrators/explicit/half_explicit.hpp"
#include "integrators/explicit/odeint.hpp"
#include "integrators/quad.hpp"

namespace trivium::integrators {

namespace {

template <class S, class Stepper>
auto chosen_runge_kutta(int order, const Tolerances& tolerances) {
  using Controlled = odeint::controlled_runge_kutta<Stepper>;
  return adapt<S>(ChosenSteps<S, Controlled>(
      Controlled(typename Controlled::error_checker_type(S(tolerances.atol), S(tolerances.rtol))), order,
      tolerances));
}

template <class S>
std::unique_ptr<AnyMethod<S>> chosen_adams(const Tolerances& tolerances) {
  if constexpr (std::is_same_v<S, double>) {
    using Controlled = odeint::controlled_adams_bashforth_moulton<AdaptiveAdams>;
    constexpr double no_limit = 1e300;
    return adapt<double>(ChosenSteps<double, Controlled>(
        Controlled({tolerances.atol, tolerances.rtol, no_limit}), 1, tolerances));
  } else {
    throw UsageError("abm chooses its steps in double alone (Odeint's choice does); give it a step");
  }
}

}  // namespace

template <class S>
std::unique_ptr<AnyMethod<S>> make_explicit(std::string_view name,
                                            const std::optional<Tolerances>& tolerances) {
  if (name == "dopri5")
    return tolerances ? chosen_runge_kutta<S, DormandPrince5<S>>(5, *tolerances)
                      : adapt<S>(GivenSteps<S, DormandPrince5<S>>());
  if (name == "rkf78")
    return tolerances ? chosen_runge_kutta<S, Fehlberg78<S>>(8, *tolerances)
                      : adapt<S>(GivenSteps<S, Fehlberg78<S>>());
  if (name == "bulirsch-stoer")
    return adapt<S>(ChosenSteps<S, BulirschStoer<S>>(
        BulirschStoer<S>(S(tolerances.value().atol), S(tolerances->rtol)), 8, *tolerances));
  if (name == "abm")
    return tolerances ? chosen_adams<S>(*tolerances) : adapt<S>(GivenSteps<S, AdamsBashforthMoulton<S>>());
  if (name == "hem4") return adapt<S>(HalfExplicit<AnySystem<S>, Hem4Coefficients<S>>());
  if (name == "hedop5") return adapt<S>(HalfExplicit<AnySystem<S>, Hedop5Coefficients<S>>(tolerances));
  return nullptr;
}

template std::unique_ptr<AnyMethod<double>> make_explicit<double>(std::string_view,
                                                                  const std::optional<Tolerances>&);
template std::unique_ptr<AnyMethod<Quad>> make_explicit<Quad>(std::string_view,
                                                              const std::optional<Tolerances>&);

}  // namespace trivium::integrators
