#pragma once
/// The list entries of the implicit methods: each checks the range of its own parameters. The template is
/// instantiated in one translation unit per Scalar (instances/).
///
/// Defaults: rho = 0.8 and alpha = -0.2 damp the fastest oscillations within some ten steps. Without damping
/// (rho = 1, alpha = 0) the multipliers of index 3 oscillate. Chosen steps excite these oscillations anew
/// wherever the length changes, so they need some damping: by experiment a quarter of the default damping.
/// With the largest damping (rho = 0, alpha = -1/3) slow motions lose more energy. The order 2 of bdf is the
/// highest at which it is A-stable.

#include <fmt/format.h>

#include "integrators/chosen_steps.hpp"
#include "integrators/implicit/bdf.hpp"
#include "integrators/implicit/generalized_alpha.hpp"
#include "integrators/implicit/hht.hpp"
#include "integrators/implicit/methods.hpp"
#include "integrators/implicit/radau.hpp"

namespace trivium::integrators {

namespace detail {

/// The given value, or else the standard one. Throws a UsageError outside least to most.
template <class Value>
Value checked(const char* what, const std::optional<Value>& given, Value standard, Value least, Value most) {
  const Value value = given.value_or(standard);
  if (!(value >= least && value <= most))
    throw UsageError(fmt::format("{} = {}; accepted: {:.4g} to {:.4g}", what, value,
                                 static_cast<double>(least), static_cast<double>(most)));
  return value;
}

}  // namespace detail

template <class S>
std::vector<MethodEntry<S>> implicit_methods() {
  using Request = const MethodRequest&;
  using Made = std::unique_ptr<AnyMethod<S>>;
  static constexpr auto newton = [](Request request) {
    return NewtonOptions{.is_full = request.given.full_newton.value_or(false)};
  };
  static constexpr auto generalized_alpha = [](Request request, bool is_stabilised) -> Made {
    return with_steps<S>(request, 2,
                         GeneralizedAlpha<AnySystem<S>>(
                             request.tolerances && !is_stabilised
                                 ? detail::checked("rho with chosen steps", request.given.rho, 0.8, 0.0, 0.95)
                                 : detail::checked("rho", request.given.rho, 0.8, 0.0, 1.0),
                             is_stabilised, newton(request)));
  };
  return {
      {{.name = "generalized-alpha",
        .summary = "generalised-alpha on Lie groups, index 3",
        .order = 2,
        .takes_given_steps = true,
        .chooses_steps = true,
        .meets_constraints = true,
        .takes_rho = true,
        .takes_full_newton = true},
       [](Request request) { return generalized_alpha(request, false); }},
      {{.name = "generalized-alpha-gl2",
        .summary = "generalised-alpha on Lie groups, stabilised index 2",
        .order = 2,
        .takes_given_steps = true,
        .chooses_steps = true,
        .meets_constraints = true,
        .takes_rho = true,
        .takes_full_newton = true},
       [](Request request) { return generalized_alpha(request, true); }},
      {{.name = "hht",
        .summary = "Hilber-Hughes-Taylor, index 3",
        .order = 2,
        .takes_given_steps = true,
        .chooses_steps = true,
        .meets_constraints = true,
        .takes_alpha = true,
        .takes_full_newton = true},
       [](Request request) -> Made {
         return with_steps<S>(
             request, 2,
             HHT<AnySystem<S>>(
                 request.tolerances
                     ? detail::checked("alpha with chosen steps", request.given.alpha, -0.2, -1.0 / 3, -0.05)
                     : detail::checked("alpha", request.given.alpha, -0.2, -1.0 / 3, 0.0),
                 newton(request)));
       }},
      {{.name = "radau5",
        .summary = "Radau IIA of 3 stages, stabilised index 2",
        .order = 5,
        .takes_given_steps = true,
        .chooses_steps = true,
        .meets_constraints = true,
        .raw_lambda_order = 3,
        .takes_full_newton = true},
       [](Request request) -> Made {
         return adapt<S>(Radau5<AnySystem<S>>(request.tolerances, newton(request)));
       }},
      {{.name = "radau9",
        .summary = "Radau IIA of 5 stages, stabilised index 2",
        .order = 9,
        .takes_given_steps = true,
        .chooses_steps = true,
        .meets_constraints = true,
        .raw_lambda_order = 5,
        .takes_full_newton = true},
       [](Request request) -> Made {
         return adapt<S>(Radau9<AnySystem<S>>(request.tolerances, newton(request)));
       }},
      {{.name = "bdf",
        .summary = "backward differentiation, orders 1 to 5, index 3",
        .standard_order = 2,
        .takes_given_steps = true,
        .chooses_steps = true,
        .meets_constraints = true,
        .takes_order = true,
        .takes_full_newton = true},
       [](Request request) -> Made {
         const int order = detail::checked("order of bdf", request.given.order, 2, 1, 5);
         return with_steps<S>(request, order, BDF<AnySystem<S>>(order, newton(request)),
                              BDF<AnySystem<S>>::most_growth(order));
       }},
  };
}

}  // namespace trivium::integrators
