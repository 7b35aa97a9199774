#include "validation/hard/solved_state.hpp"

#include "base/raise.hpp"
#include "bodies/numbers/real50.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "mechanism/mechanism_cast.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium::hard {

namespace {

SolvedState compared(const RowAnalysis& rows, const FormulationResult<double>& found,
                     const std::string& solver, const PhysicalSolution<double>& exact) {
  SolvedState state{found.name, solver, found.error};
  if (!found.error.empty()) return state;
  state.lambda = compare_lambda(rows, found.solution.lambda, exact.lambda).error();
  for (std::size_t b = 0; b < exact.omega_bar_dot.size(); ++b)
    raise(state.omega_bar_dot,
          (found.solution.omega_bar_dot[b] - exact.omega_bar_dot[b]).lpNorm<Eigen::Infinity>());
  state.announced = stated_error(found);
  return state;
}

}  // namespace

double stated_error(const FormulationResult<double>& found) {
  return found.estimate.lambda <= uncertain_from ? 0 : found.estimate.lambda;
}

PhysicalSolution<double> solution_in_quad(const Model<Quad>& model, const RowAnalysis& rows) {
  const SideBySide<Quad> quad = side_by_side(model, rows, SolveOptions{{"r-omega"}, {}});
  quad.require_solved();
  const PhysicalSolution<Quad>& x = quad.formulations.front().solution;
  PhysicalSolution<double> out{{}, {}, scalar_cast<double>(x.lambda)};
  for (std::size_t b = 0; b < x.r_ddot.size(); ++b) {
    out.r_ddot.push_back(scalar_cast<double>(x.r_ddot[b]));
    out.omega_bar_dot.push_back(scalar_cast<double>(x.omega_bar_dot[b]));
  }
  return out;
}

SolvedStates solve_state(const scenes::Scene& scene, const std::vector<std::string>& formulations,
                         const ChartOptions& charts) {
  const auto model = make_model<double>(scene);
  const RowAnalysis rows = analyse_rows(model);
  const PhysicalSolution<double> exact = solution_in_quad(make_model<Quad>(scene), rows);
  SolvedStates out{rows.kappa, {}};
  const SolveOptions options{formulations, charts};
  const auto higher = make_model<NextPrecisionT<double>>(scene);
  for (const auto& found : side_by_side(model, rows, options, &higher).formulations)
    out.all.push_back(compared(rows, found, "printed", exact));
  for (const auto& found : structured_side_by_side(model, options).formulations)
    out.all.push_back(compared(rows, found, "structured", exact));
  return out;
}

}  // namespace trivium::hard
