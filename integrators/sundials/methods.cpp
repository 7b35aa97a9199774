#include "integrators/sundials/methods.hpp"

#include <fmt/format.h>

#include "integrators/contract/errors.hpp"

namespace trivium::integrators {

DoubleMethod make_sundials(std::string_view name, const std::optional<Tolerances>& tolerances,
                           const MethodParameters& given) {
  if (name == "cvode-adams") return make_cvode_adams(tolerances.value());
  if (name == "cvode-bdf") return make_cvode_bdf(tolerances.value(), given.projects);
  if (name == "ida") return make_ida(tolerances.value());
  const bool is_implicit = name == "arkode-dirk";
  if (!is_implicit && name != "arkode-erk") return nullptr;
  const int order = given.order.value_or(5);
  if (order < 2 || order > (is_implicit ? 5 : 8) || order == 7)
    throw UsageError(
        fmt::format("an order {} of {}; accepted: {}", order, name, is_implicit ? "2 to 5" : "2 to 6 and 8"));
  return make_arkode(is_implicit, order, tolerances);
}

}  // namespace trivium::integrators
