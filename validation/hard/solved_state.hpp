#pragma once
/// One state solved in every formulation by both solvers. The errors are those against r-omega in quad, and
/// beside them stands the error that each solver states by itself.

#include <string>
#include <vector>

#include "bodies/numbers/quad.hpp"
#include "formulations/contract/chart_options.hpp"
#include "formulations/side_by_side.hpp"
#include "scenes/scene.hpp"

namespace trivium::hard {

struct SolvedState {
  std::string formulation, solver;  ///< solver: printed or structured
  std::string refusal;              ///< empty if solved
  double lambda = 0;                ///< relative error (formulations/analysis/comparison.hpp)
  double omega_bar_dot = 0;         ///< largest error of a component [rad/s^2]
  double announced = 0;             ///< stated_error
};

struct SolvedStates {
  double kappa = 1;
  std::vector<SolvedState> all;
};

/// The error of lambda that a solver states by itself; 0 if it is too small for a warning.
double stated_error(const FormulationResult<double>& found);

/// The solution of r-omega in quad, rounded. Throws a ModelError if there is none.
PhysicalSolution<double> solution_in_quad(const Model<Quad>& model, const RowAnalysis& rows);

/// Throws a ModelError if the state cannot be analysed or solved in quad.
SolvedStates solve_state(const scenes::Scene& scene, const std::vector<std::string>& formulations,
                         const ChartOptions& charts = {});

}  // namespace trivium::hard
