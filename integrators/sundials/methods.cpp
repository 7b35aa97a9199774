/// Lists the integrators of SUNDIALS with their properties, and checks the order of ARKODE.

#include "integrators/sundials/methods.hpp"

#include <fmt/format.h>

#include "integrators/contract/errors.hpp"

namespace trivium::integrators {

namespace {

DoubleMethod arkode(const MethodRequest& request, bool is_implicit, std::string_view name) {
  const int order = request.given.order.value_or(5);
  if (order < 2 || order > (is_implicit ? 5 : 8) || order == 7)
    throw UsageError(
        fmt::format("order of {} = {}; accepted: {}", name, order, is_implicit ? "2 to 5" : "2 to 6 and 8"));
  return make_arkode(is_implicit, order, request.tolerances);
}

}  // namespace

std::vector<MethodEntry<double>> sundials_methods() {
  using Request = const MethodRequest&;
  return {
      {{.name = "cvode-adams", .summary = "Adams, orders 1 to 12 (CVODE)", .chooses_steps = true},
       [](Request request) { return make_cvode_adams(request.tolerances.value()); }},
      {{.name = "cvode-bdf",
        .summary = "backward differentiation, orders 1 to 5, projected within its steps (CVODE)",
        .chooses_steps = true},
       [](Request request) { return make_cvode_bdf(request.tolerances.value(), request.given.projects); }},
      {{.name = "arkode-erk",
        .summary = "explicit Runge-Kutta, of orders 2 to 6 and 8 (ARKODE)",
        .order = 5,
        .takes_given_steps = true,
        .chooses_steps = true,
        .takes_order = true},
       [](Request request) { return arkode(request, false, "arkode-erk"); }},
      {{.name = "arkode-dirk",
        .summary = "diagonally implicit Runge-Kutta, of orders 2 to 5 (ARKODE)",
        .order = 5,
        .takes_given_steps = true,
        .chooses_steps = true,
        .takes_order = true},
       [](Request request) { return arkode(request, true, "arkode-dirk"); }},
      {{.name = "ida",
        .summary = "backward differentiation, orders 1 to 5, stabilised index 2 (IDA)",
        .chooses_steps = true,
        .meets_constraints = true},
       [](Request request) { return make_ida(request.tolerances.value()); }},
  };
}

}  // namespace trivium::integrators
