#pragma once
/// All formulations solved at one state of one scene, and the differences between their solutions. The
/// theorem of the paper is tested here: lambda is the same in all formulations. Each is solved as printed;
/// differences are relative, and their bound is 100 u kappa (analysis/comparison.hpp). Formulations are
/// selected by name at run time here; the code below this level is compiled for one formulation each.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "base/raise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/comparison.hpp"
#include "formulations/formulation_list.hpp"
#include "formulations/joint_reaction.hpp"
#include "formulations/printed/error_estimate.hpp"
#include "mechanism/model.hpp"

namespace trivium {

/// Which formulations are solved, and in which charts.
struct SolveOptions {
  std::vector<std::string> formulations;  ///< names; empty: all formulations of the list
  ChartOptions charts;
};

/// The solution of one formulation, or the error that prevented it.
template <class Scalar>
struct FormulationResult {
  std::string name;
  std::string error;  ///< empty if solved
  PhysicalSolution<Scalar> solution;
  VectorX<Scalar> lambda_internal;  ///< lambda^p in r-p
  std::vector<Reaction<Scalar>>
      reactions;  ///< one per joint: on body j, global frame, about the joint's point on body i
  std::vector<std::string> charts;  ///< one per body; empty for formulations without charts
  ErrorEstimate estimate;
  MatrixFreeResidual residual;
};

/// Relative differences of lambda, r'' and omega_bar' [-].
struct Discrepancy {
  double lambda = 0, r_ddot = 0, omega_bar_dot = 0;
};

/// The solutions of all requested formulations at one state, and the row analysis that they share.
template <class Scalar>
struct SideBySide {
  RowAnalysis rows;
  std::vector<FormulationResult<Scalar>> formulations;

  bool any_unique() const {
    return std::find(rows.unique.begin(), rows.unique.end(), true) != rows.unique.end();
  }
  /// The smallest cancellation factor of lambda (Comparison::cancellation) over the solved formulations.
  double cancellation() const {
    if (rows.E.size() != static_cast<Eigen::Index>(rows.unique.size())) return 1;  // norms are not determined
    double least = std::numeric_limits<double>::infinity();
    for (const auto& f : formulations)
      if (f.error.empty())
        least = std::min(least, compare_lambda(rows, f.solution.lambda, f.solution.lambda).cancellation());
    return std::isfinite(least) ? least : 1.0;
  }
  /// Throws the ModelError of the first formulation without a solution; discrepancy() does not see such a
  /// formulation.
  void require_solved() const {
    for (const auto& f : formulations)
      if (!f.error.empty()) throw ModelError(fmt::format("{}: {}", f.name, f.error));
  }
  /// The bound of discrepancy().lambda: 100 u kappa.
  double lambda_bound() const {
    return trivium::lambda_bound(static_cast<double>(unit_roundoff<Scalar>()), rows.kappa);
  }
  /// The largest differences between any two solved formulations; NaN if the norms E are not known.
  Discrepancy discrepancy() const {
    Discrepancy worst;
    if (rows.E.size() != static_cast<Eigen::Index>(rows.unique.size())) {
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      return {unknown, unknown, unknown};
    }
    for (std::size_t a = 0; a < formulations.size(); ++a)
      for (std::size_t b = a + 1; b < formulations.size(); ++b) {
        if (!formulations[a].error.empty() || !formulations[b].error.empty()) continue;
        const auto& x = formulations[a].solution;
        const auto& y = formulations[b].solution;
        const AccelerationDistance d = acceleration_distance(rows, x, y);
        raise(worst.lambda, lambda_distance(rows, x.lambda, y.lambda));
        raise(worst.r_ddot, d.r_ddot);
        raise(worst.omega_bar_dot, d.omega_bar_dot);
      }
    return worst;
  }
};

/// Solves a model as printed in the requested formulations. A formulation that fails has an entry with its
/// error. What concerns all formulations (a motion without inertia and rows, an effect that is not defined at
/// this state) is an error of analyse_rows() already. With `judge`, the same model in the next precision,
/// errors are estimated. Compiled in instances/ for float to Real50; for other formulations, constraints or
/// effects include side_by_side_impl.hpp.
template <class List = AllFormulations, class Scalar, class Types>
SideBySide<Scalar> side_by_side(
    const Model<Scalar, Types>& model, const RowAnalysis& rows, const SolveOptions& options = {},
    const Model<NextPrecisionT<Scalar>, std::type_identity_t<Types>>* judge = nullptr);

}  // namespace trivium
