/// Joins the lists of the folders into one. Steps and parameters are checked against the entry here, so that
/// a method need not check whether it was asked for something that it does not offer.

#include "integrators/methods.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

namespace {

template <class S>
const std::vector<MethodEntry<S>>& entries() {
  static const std::vector<MethodEntry<S>> all = [] {
    std::vector<MethodEntry<S>> list;
    const auto add = [&](const std::vector<MethodEntry<S>>& kind) {
      list.insert(list.end(), kind.begin(), kind.end());
    };
    add(explicit_methods<S>());
    add(implicit_methods<S>());
    add(symplectic_methods<S>());
    if constexpr (std::is_same_v<S, double>) add(sundials_methods());
    return list;
  }();
  return all;
}

}  // namespace

const std::vector<MethodInfo>& methods() {
  static const std::vector<MethodInfo> all = [] {
    std::vector<MethodInfo> infos;
    for (const MethodEntry<double>& entry : entries<double>()) infos.push_back(entry.info);
    return infos;
  }();
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

/// Throws a UsageError if the method does not take these steps or parameters.
void check(const MethodInfo& method, Steps steps, const MethodParameters& given) {
  if (steps == Steps::given && !method.takes_given_steps)
    throw UsageError(
        fmt::format("{} controls its step size by tolerances and does not take steps of a given length; give "
                    "rtol and atol, or take another method",
                    method.name));
  if (steps == Steps::chosen && !method.chooses_steps)
    throw UsageError(fmt::format("{} takes steps of a given length only; give the step", method.name));
  const auto only = [&](bool is_given, const char* what, bool MethodInfo::*takes) {
    if (!is_given || method.*takes) return;
    std::vector<std::string_view> names;
    for (const MethodInfo& one : methods())
      if (one.*takes) names.push_back(one.name);
    throw UsageError(fmt::format("{} is not a parameter of {}; methods that take it: {}", what, method.name,
                                 fmt::join(names, ", ")));
  };
  only(given.order.has_value(), "the order", &MethodInfo::takes_order);
  only(given.rho.has_value(), "rho", &MethodInfo::takes_rho);
  only(given.alpha.has_value(), "alpha", &MethodInfo::takes_alpha);
  only(given.full_newton.has_value(), "full Newton (a new matrix in every iteration)",
       &MethodInfo::takes_full_newton);
}

}  // namespace

template <class S>
const MethodEntry<S>& method_entry(std::string_view name) {
  for (const MethodEntry<S>& entry : entries<S>())
    if (entry.info.name == name) return entry;
  if (find_method(name) == nullptr) throw UsageError(fmt::format("there is no method \"{}\"", name));
  throw UsageError(
      fmt::format("{} is available in double precision only (a SUNDIALS method); take another method", name));
}

template <class S>
std::unique_ptr<AnyMethod<S>> make_method(const MethodEntry<S>& method, Steps steps,
                                          const Tolerances& tolerances, const MethodParameters& given) {
  check(method.info, steps, given);
  const bool chosen = steps == Steps::chosen;
  // u here is the machine epsilon, twice the unit roundoff. A step rounds y by about four epsilons, below
  // which an error estimate measures rounding only.
  if (const double u = static_cast<double>(std::numeric_limits<S>::epsilon());
      chosen && tolerances.rtol < 4 * u && tolerances.atol < 4 * u)
    throw UsageError(
        fmt::format("rtol {} and atol {} are both below the rounding error of a step; accepted: at least one "
                    "of them {:.1e} or larger",
                    tolerances.rtol, tolerances.atol, 4 * u));
  return method.make({chosen ? std::optional(tolerances) : std::nullopt, given});
}

template <class S>
std::unique_ptr<AnyMethod<S>> make_method(std::string_view name, Steps steps, const Tolerances& tolerances,
                                          const MethodParameters& given) {
  return make_method(method_entry<S>(name), steps, tolerances, given);
}

template const MethodEntry<double>& method_entry<double>(std::string_view);
template std::unique_ptr<AnyMethod<double>> make_method<double>(const MethodEntry<double>&, Steps,
                                                                const Tolerances&, const MethodParameters&);
template std::unique_ptr<AnyMethod<double>> make_method<double>(std::string_view, Steps, const Tolerances&,
                                                                const MethodParameters&);
template const MethodEntry<Quad>& method_entry<Quad>(std::string_view);
template std::unique_ptr<AnyMethod<Quad>> make_method<Quad>(const MethodEntry<Quad>&, Steps,
                                                            const Tolerances&, const MethodParameters&);
template std::unique_ptr<AnyMethod<Quad>> make_method<Quad>(std::string_view, Steps, const Tolerances&,
                                                            const MethodParameters&);

}  // namespace trivium::integrators
