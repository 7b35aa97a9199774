#include "validation/hard/solved_state.hpp"

#include <algorithm>

#include "base/raise.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "mechanism/mechanism_cast.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium::hard {

namespace {

PhysicalSolution<double> in_double(const PhysicalSolution<Quad>& x) {
  PhysicalSolution<double> out;
  for (const auto& r_ddot : x.r_ddot) out.r_ddot.push_back(scalar_cast<double>(r_ddot));
  for (const auto& omega_bar_dot : x.omega_bar_dot)
    out.omega_bar_dot.push_back(scalar_cast<double>(omega_bar_dot));
  out.lambda = scalar_cast<double>(x.lambda);
  return out;
}

SolvedState compared(const RowAnalysis& rows, const FormulationResult<double>& found,
                     const std::string& solver, const PhysicalSolution<double>& exact) {
  SolvedState state{found.name, solver, found.error};
  if (!found.error.empty()) return state;
  state.lambda = compare_lambda(rows, found.solution.lambda, exact.lambda).error();
  state.acceleration = compare_accelerations(rows, found.solution, exact).all.error();
  for (std::size_t b = 0; b < exact.omega_bar_dot.size(); ++b)
    raise(state.omega_bar_dot,
          (found.solution.omega_bar_dot[b] - exact.omega_bar_dot[b]).lpNorm<Eigen::Infinity>());
  if (!(found.estimate.lambda <= uncertain_from)) state.announced = found.estimate.lambda;
  return state;
}

}  // namespace

SolvedStates solve_state(const scenes::Scene& scene, const std::vector<std::string>& formulations,
                         const ChartOptions& charts) {
  const auto model = make_model<double>(scene);
  const RowAnalysis rows = analyse_rows(model);
  const SideBySide<Quad> quad = side_by_side(make_model<Quad>(scene), rows, SolveOptions{{"r-omega"}, {}});
  quad.require_solved();
  const PhysicalSolution<double> exact = in_double(quad.formulations.front().solution);
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
