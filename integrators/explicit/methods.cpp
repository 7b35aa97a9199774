/// Makes the methods of Odeint and the half-explicit methods from a request, and lists their properties.

#include "integrators/explicit/methods.hpp"

#include <type_traits>
#include <utility>

#include "integrators/chosen_steps.hpp"
#include "integrators/explicit/fehlberg_control.hpp"
#include "integrators/explicit/half_explicit.hpp"
#include "integrators/explicit/odeint.hpp"
#include "integrators/quad.hpp"

namespace trivium::integrators {

namespace {

template <class S>
std::unique_ptr<AnyMethod<S>> dormand_prince(const MethodRequest& request) {
  if (!request.tolerances) return adapt<S>(GivenSteps<S, DormandPrince5<S>>());
  using Controlled = odeint::controlled_runge_kutta<DormandPrince5<S>>;
  const Tolerances& tolerances = *request.tolerances;
  return adapt<S>(ChosenSteps<S, Controlled>(
      Controlled(typename Controlled::error_checker_type(S(tolerances.atol), S(tolerances.rtol))), 5,
      tolerances));
}

template <class S>
std::unique_ptr<AnyMethod<S>> fehlberg(const MethodRequest& request) {
  if (!request.tolerances) return adapt<S>(GivenSteps<S, Fehlberg78<S>>());
  return adapt<S>(ChosenSteps<S, FehlbergControl<S>>(
      FehlbergControl<S>(*request.tolerances, request.given.depends_on_time), 8, *request.tolerances));
}

template <class S>
std::unique_ptr<AnyMethod<S>> chosen_adams(const Tolerances& tolerances) {
  if constexpr (std::is_same_v<S, double>) {
    constexpr double no_limit = 1e300;  // of the step size [s]
    // the controller begins with order 1
    return adapt<double>(ChosenSteps<double, ControlledAdams>(
        ControlledAdams({tolerances.atol, tolerances.rtol, no_limit}), 1, tolerances));
  } else {
    throw UsageError(
        "abm controls its step size in double precision only (a limit of Odeint); give a step, or use "
        "double");
  }
}

}  // namespace

template <class S>
std::vector<MethodEntry<S>> explicit_methods() {
  using Request = const MethodRequest&;
  using Made = std::unique_ptr<AnyMethod<S>>;
  return {
      {{.name = "dopri5",
        .summary = "Dormand-Prince 5(4), explicit Runge-Kutta (Odeint)",
        .order = 5,
        .takes_given_steps = true,
        .chooses_steps = true},
       [](Request request) { return dormand_prince<S>(request); }},
      {{.name = "rkf78",
        .summary = "Fehlberg 7(8), explicit Runge-Kutta (Odeint)",
        .order = 8,
        .takes_given_steps = true,
        .chooses_steps = true},
       [](Request request) { return fehlberg<S>(request); }},
      {{.name = "bulirsch-stoer",
        .summary = "Bulirsch-Stoer extrapolation, orders 4 to 16 (Odeint)",
        .chooses_steps = true},
       [](Request request) -> Made {
         const Tolerances& tolerances = request.tolerances.value();
         // the order varies from 4 to 16; the first step is chosen for a middle value
         return adapt<S>(ChosenSteps<S, BulirschStoer<S>>(
             BulirschStoer<S>(S(tolerances.atol), S(tolerances.rtol)), 8, tolerances));
       }},
      {{.name = "abm",
        .summary = "Adams-Bashforth-Moulton, multistep, orders 1 to 12, order 5 with given steps (Odeint)",
        .order = 5,
        .takes_given_steps = true,
        .chooses_steps = true},
       [](Request request) -> Made {
         if (request.tolerances) return chosen_adams<S>(*request.tolerances);
         return adapt<S>(GivenSteps<S, AdamsBashforthMoulton<S>>());
       }},
      {{.name = "hedop5",
        .summary = "half-explicit Dormand-Prince 5(4), index 2",
        .order = 5,
        .takes_given_steps = true,
        .chooses_steps = true,
        .has_raw_lambda = true,
        .raw_lambda_order = 4},
       [](Request request) -> Made {
         return adapt<S>(HalfExplicit<AnySystem<S>, Hedop5Coefficients<S>>(request.tolerances));
       }},
      {{.name = "hem4",
        .summary = "half-explicit Runge-Kutta, index 2",
        .order = 4,
        .takes_given_steps = true,
        .chooses_steps = true,
        .has_raw_lambda = true,
        .raw_lambda_order = 2},
       [](Request request) -> Made {
         return with_steps<S>(request, 4, HalfExplicit<AnySystem<S>, Hem4Coefficients<S>>());
       }},
  };
}

template std::vector<MethodEntry<double>> explicit_methods<double>();
template std::vector<MethodEntry<Quad>> explicit_methods<Quad>();

}  // namespace trivium::integrators
