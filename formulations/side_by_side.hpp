#pragma once
/// All formulations at one state of one scene, side by side: the run-time edge of the library.

#include <optional>
#include <string>
#include <vector>

#include "formulations/augmented_solver.hpp"
#include "formulations/reaction.hpp"

namespace trivium {

/// The names of the formulations, in the order in which they are reported.
std::vector<std::string> formulation_names();

struct SolveOptions {
  std::vector<std::string> formulations = formulation_names();
  ChartOptions charts;
  bool estimate_errors = true;
};

/// One formulation's answer, or the error that kept it from answering.
template <class Scalar>
struct FormulationResult {
  std::string name;
  std::string error;  ///< empty if solved
  PhysicalSolution<Scalar> solution;
  VectorX<Scalar> lambda_internal;  ///< lambda^p in r-p
  std::vector<Reaction<Scalar>>
      reactions;                    ///< per joint, on body j, global frame, about the joint's point on i
  std::vector<std::string> charts;  ///< per body; empty for formulations without charts
  ErrorEstimate estimate;
  MatrixFreeResidual residual;
};

struct Discrepancy {
  double lambda = 0, r_ddot = 0, omega_bar_dot = 0;
};

template <class Scalar>
struct SideBySide {
  RowAnalysis rows;
  std::vector<FormulationResult<Scalar>> formulations;

  bool any_unique() const {
    return std::find(rows.unique.begin(), rows.unique.end(), true) != rows.unique.end();
  }
  /// How much of what could cause lambda cancels (Comparison), the least over the formulations that solved.
  double cancellation() const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& f : formulations)
      if (f.error.empty())
        least = std::min(least, compare_lambda(rows, f.solution.lambda, f.solution.lambda).cancellation());
    return std::isfinite(least) ? least : 1.0;
  }
  /// The bound of lambda's discrepancy: 100 u kappa.
  double lambda_bound() const { return 100 * static_cast<double>(unit_roundoff<Scalar>()) * rows.kappa; }
  /// The largest difference between any two formulations that solved.
  Discrepancy discrepancy() const {
    Discrepancy worst;
    for (std::size_t a = 0; a < formulations.size(); ++a)
      for (std::size_t b = a + 1; b < formulations.size(); ++b) {
        if (!formulations[a].error.empty() || !formulations[b].error.empty()) continue;
        const auto& x = formulations[a].solution;
        const auto& y = formulations[b].solution;
        const AccelerationDistance d = acceleration_distance(rows, x, y);
        worst.lambda = std::max(worst.lambda, lambda_distance(rows, x.lambda, y.lambda));
        worst.r_ddot = std::max(worst.r_ddot, d.r_ddot);
        worst.omega_bar_dot = std::max(worst.omega_bar_dot, d.omega_bar_dot);
      }
    return worst;
  }
};

/// Solves the scene's state, taken as the state at time t. A formulation that cannot is an entry with an
/// error; what no formulation can do (singular mass without constraint, an effect that is not defined here)
/// throws a ModelError.
template <class Scalar>
SideBySide<Scalar> solve_side_by_side(const scenes::Scene& scene, double t, const SolveOptions& options = {});

extern template SideBySide<float> solve_side_by_side(const scenes::Scene&, double, const SolveOptions&);
extern template SideBySide<double> solve_side_by_side(const scenes::Scene&, double, const SolveOptions&);
extern template SideBySide<long double> solve_side_by_side(const scenes::Scene&, double, const SolveOptions&);
extern template SideBySide<Quad> solve_side_by_side(const scenes::Scene&, double, const SolveOptions&);
extern template SideBySide<Real50> solve_side_by_side(const scenes::Scene&, double, const SolveOptions&);

/// How full a formulation's printed augmented matrix is, all rows of Phi in it.
struct Sparsity {
  std::string name;
  long size = 0, nonzeros = 0;
  double percent() const {
    return size == 0 ? 0.0
                     : 100.0 * static_cast<double>(nonzeros) /
                           (static_cast<double>(size) * static_cast<double>(size));
  }
};
/// Entries that are not zero at the scene's state, in every formulation; nothing dense is built.
std::vector<Sparsity> augmented_sparsity(const scenes::Scene& scene, double t);

/// The printed form is dense: beyond this many unknowns (6 nb + nc) it takes minutes and gigabytes, and is
/// refused.
inline constexpr int most_dense_unknowns = 6000;

/// The row analysis of the scene's state, in double; throws a ModelError that names scene and time.
RowAnalysis analyse_rows(const scenes::Scene& scene, double t);

}  // namespace trivium
