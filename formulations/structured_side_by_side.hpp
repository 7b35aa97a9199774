#pragma once
/// All formulations at one state, solved by the structured solver, for mechanisms too large for the dense
/// solver of side_by_side.hpp. The dense row analysis is replaced: rank and uniqueness come from the
/// structured solver, kappa is not known (NaN), and the error estimates are the corrections of the last
/// iterative refinement, or near the singularity of a chart how far roundings of the state move the solution.

#include "formulations/side_by_side.hpp"

namespace trivium {

/// Whether a mechanism has too many unknowns for the dense solver.
template <class Types>
bool is_beyond_dense(const Mechanism<double, Types>& mechanism) {
  return 6 * mechanism.nb() + mechanism.nc() > most_dense_unknowns;
}

/// The part of the row analysis that needs no dense matrix: dependent rows, rank, uniqueness, norms. Throws
/// a ModelError if accelerations do not exist at this state.
RowAnalysis structured_row_analysis(const Model<double>& model);

/// Solves the requested formulations. The norms E are known if all inertias are regular; otherwise
/// discrepancies are NaN.
SideBySide<double> structured_side_by_side(const Model<double>& model, const SolveOptions& options = {});

}  // namespace trivium
