#pragma once
/// The definition of side_by_side, compiled in one translation unit per Scalar. Each formulation is solved
/// as printed in its own chart; a formulation that fails does not affect the others.

#include <cmath>

#include "base/raise.hpp"
#include "formulations/printed/augmented_solver.hpp"
#include "formulations/side_by_side.hpp"

#include "bodies/numbers/scalar.hpp"

namespace trivium::detail {

/// The result of one formulation without its name; throws a ModelError if the formulation cannot be solved.
template <EquationsAsPrinted F>
FormulationResult<typename F::Scalar> solve_one(
    const ModelOf<F>& model, const Model<NextPrecisionT<typename F::Scalar>, MechanismTypesOf<F>>* judge,
    const RowAnalysis& rows, const ChartOptions& charts) {
  using S = typename F::Scalar;
  using Higher = InScalarT<F, NextPrecisionT<S>>;
  FormulationResult<S> result;
  const AugmentedSolver<F> solver(model.mechanism, model.state, rows, charts);
  const VectorX<S> x = solver.solve_reduced();
  const VectorX<S> full = solver.to_minimum_norm(solver.expand(x));
  result.solution = solver.accelerations_of(full);
  result.lambda_internal = solver.split(full).lambda_internal;
  // The residual is computed before lambda is distributed over dependent rows: the distribution would add
  // rounding to multipliers that are zero
  result.residual = solver.residual(solver.expand(x));
  for (const Joint<S>& joint : model.mechanism.joints)
    result.reactions.push_back(joint_reaction<F>(solver.equations(), joint, result.solution.lambda, End::j)
                                   .about(joint_point<F>(solver.equations(), joint)));
  for (const BodyState<F>& body : solver.states())
    if (const std::string chart(body.chart.name()); !chart.empty()) result.charts.push_back(chart);
  if (judge) {
    const AugmentedEquations<Higher> higher(judge->mechanism, judge->state, rows, charts);
    result.estimate = estimate_error(solver, x, higher);
    // A solver with sound factors leaves a residual of a few u. If the relative
    // residual exceeds sqrt(u), as in a chart at its singularity, the factors are too inaccurate for
    // corrections that tell the error: no digit is known.
    const double u = static_cast<double>(unit_roundoff<S>());
    if (!(result.residual.worst() <= std::sqrt(u))) {
      raise(result.estimate.lambda, 1 / u);
      raise(result.estimate.acceleration, 1 / u);
    }
  }
  return result;
}

/// Appends solve(name), or its error, for each requested name to `out`; t is the time of the state [s].
template <class Scalar, class Solve>
void solve_each(const std::vector<std::string>& names, const SolveOptions& options, const Scalar& t,
                SideBySide<Scalar>& out, const Solve& solve) {
  const auto& wanted = options.formulations;
  for (const std::string& name : names) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    FormulationResult<Scalar> result;
    try {
      result = solve(name);
    } catch (const ModelError& error) {
      const Place here{"", static_cast<double>(t)};
      result.error = error.when() ? error.what() : ModelError(here, error).what();
    }
    result.name = name;
    out.formulations.push_back(std::move(result));
  }
}

/// Instances for the formulations of the library are compiled in instances/.
#define TRIVIUM_SOLVE_ONE(F, S, kind)                                                                  \
  kind template FormulationResult<S> solve_one<F<S>>(const Model<S>&, const Model<NextPrecisionT<S>>*, \
                                                     const RowAnalysis&, const ChartOptions&);
TRIVIUM_FORMULATIONS(TRIVIUM_SOLVE_ONE, double, extern)

}  // namespace trivium::detail

namespace trivium {

template <class List, class Scalar, class Types>
SideBySide<Scalar> side_by_side(const Model<Scalar, Types>& model, const RowAnalysis& rows,
                                const SolveOptions& options,
                                const Model<NextPrecisionT<Scalar>, std::type_identity_t<Types>>* judge) {
  SideBySide<Scalar> out{rows, {}};
  detail::solve_each(List::names(), options, model.state.t, out, [&](const std::string& name) {
    return with_formulation<Scalar, List>(name, [&]<EquationsAsPrinted F>() {
      return detail::solve_one<F>(model, judge, rows, options.charts);
    });
  });
  return out;
}

}  // namespace trivium
