#pragma once
/// All formulations at one state of one scene, side by side, which is the theorem of the paper: lambda is the
/// same in all of them. Each is solved as printed; discrepancies are relative, and their bound is 100 u kappa
/// (analysis/comparison.hpp). Formulations are told apart at run time here and nowhere below.

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

struct SolveOptions {
  std::vector<std::string> formulations;  ///< by name; empty: all of the list
  ChartOptions charts;
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
  /// Throws the error of the first formulation that did not solve: it is in no discrepancy.
  void require_solved() const {
    for (const auto& f : formulations)
      if (!f.error.empty()) throw ModelError(fmt::format("{}: {}", f.name, f.error));
  }
  /// The bound of lambda's discrepancy: 100 u kappa.
  double lambda_bound() const {
    return trivium::lambda_bound(static_cast<double>(unit_roundoff<Scalar>()), rows.kappa);
  }
  /// The largest difference between any two formulations that solved; NaN where the norms are not known.
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

/// Solves a model as printed, in every formulation asked for. A formulation that cannot is an entry with an
/// error; what no formulation can do (singular mass without constraint, an effect that is not defined here)
/// throws a ModelError. Errors are estimated where the same model in more digits judges them.
/// Compiled in instances/, for float to Real50; for a list of other formulations, or
/// other types of constraints and effects, include side_by_side_impl.hpp.
template <class List = AllFormulations, class Scalar, class Types>
SideBySide<Scalar> side_by_side(
    const Model<Scalar, Types>& model, const RowAnalysis& rows, const SolveOptions& options = {},
    const Model<NextPrecisionT<Scalar>, std::type_identity_t<Types>>* judge = nullptr);

}  // namespace trivium
