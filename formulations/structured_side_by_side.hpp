#pragma once
/// All formulations at one state by the solver along the graph, for mechanisms that are too large for the
/// dense one of side_by_side.hpp. Decides what stands in the place of the dense analysis: rank and uniqueness
/// are the structured solver's, kappa is not known (NaN), and estimated errors are the last refinement's
/// corrections.

#include "formulations/side_by_side.hpp"

namespace trivium {

/// Whether a mechanism is too large for the dense solver.
template <class Types>
bool is_beyond_dense(const Mechanism<double, Types>& mechanism) {
  return 6 * mechanism.nb() + mechanism.nc() > most_dense_unknowns;
}

/// What is known of the rows at a state without a dense matrix. Throws a ModelError where the state has no
/// accelerations.
RowAnalysis structured_row_analysis(const Model<double>& model);

/// Norms are known where all inertias are regular; else differences are NaN.
SideBySide<double> structured_side_by_side(const Model<double>& model, const SolveOptions& options = {});

}  // namespace trivium
