#include "integrators/methods.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <optional>
#include <type_traits>

#include "integrators/contract/errors.hpp"
#include "integrators/explicit/methods.hpp"
#include "integrators/implicit/methods.hpp"
#include "integrators/quad.hpp"
#include "integrators/sundials/methods.hpp"
#include "integrators/symplectic/methods.hpp"

namespace trivium::integrators {

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
  if (auto made = make_explicit<S>(name, of_own_choice)) return made;
  if (auto made = make_implicit<S>(name, of_own_choice, given)) return made;
  if (auto made = make_symplectic<S>(name)) return made;
  if constexpr (std::is_same_v<S, double>)
    return make_sundials(name, of_own_choice, given);
  else
    throw UsageError(fmt::format("{} computes in double alone (SUNDIALS does); take another method", name));
}

template std::unique_ptr<AnyMethod<double>> make_method<double>(std::string_view, Steps, const Tolerances&,
                                                                const MethodParameters&);
template std::unique_ptr<AnyMethod<Quad>> make_method<Quad>(std::string_view, Steps, const Tolerances&,
                                                            const MethodParameters&);

}  // namespace trivium::integrators
