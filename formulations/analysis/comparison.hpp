#pragma once
/// Differences between two solutions of one scene: of lambda in the norm |E lambda|, of accelerations
/// weighted by the mass metric, and the magnitudes that make them relative. Defines the bound within which
/// formulations must agree: 100 u kappa.

#include <algorithm>

#include "formulations/analysis/row_analysis.hpp"
#include "formulations/solution.hpp"

namespace trivium {

/// Factor of lambda_bound, fixed before the experiments (docs/lambda.md). Many roundings, each amplified by
/// kappa, separate two formulations: 100 is a margin of two digits over a single one. A larger factor would
/// hide errors of a formulation, a smaller one could be exceeded by correct ones.
inline constexpr int bound_factor = 100;

/// The bound of the relative difference of lambda between two formulations, in arithmetic of unit roundoff
/// u: bound_factor u kappa. A difference within cancellation() times this bound is rounding error as well.
inline double lambda_bound(double u, double kappa) { return bound_factor * u * kappa; }

/// A difference of two solutions and the magnitudes that make it relative, all in one norm.
struct Comparison {
  /// The difference, the sizes of the two solutions, and reference_size: the size of the solution with |Q|
  /// and |gamma| on the right side, |E^-1 b| for lambda.
  double difference = 0, size_1 = 0, size_2 = 0, reference_size = 0;
  double size_uncancelled = 0;  ///< reference_size with every term of Q, gamma and Phi by magnitude,
                                ///< |E^-1 B| (docs/lambda.md); 0: not known

  /// The difference relative to the largest of size_1, size_2 and reference_size.
  double relative() const { return over(std::max({size_1, size_2, reference_size})); }
  /// The relative error of the first solution if the second is exact.
  double error() const { return over(std::max(size_2, reference_size)); }
  /// Cancellation factor [-], at least 1, by which rounding errors grow: size_uncancelled relative to four
  /// times the largest of size_1, size_2 and reference_size. A sum of magnitudes such as size_uncancelled
  /// exceeds the magnitude of the sum in every state. The number 4 is chosen such that the factor is 1 in
  /// ordinary states. Where a symmetric body spins fast, the factor grows with |omega_bar|^2 relative to the
  /// load.
  double cancellation() const {
    const double scale = std::max({size_1, size_2, reference_size});
    return size_uncancelled > 0 && scale > 0 ? std::max(1.0, size_uncancelled / (4 * scale)) : 1.0;
  }

 private:
  double over(double scale) const { return difference == 0 ? 0.0 : difference / scale; }
};

/// Compares lambda in the norms of `rows` (RowNorms): difference |E (lambda_1 - lambda_2)| and sizes |E
/// lambda| over the unique rows. The reference size |E^-1 b|, with b = schur_rhs_bound, is taken over all
/// rows, so that a row without load is measured relative to the loads of the others.
template <class Scalar>
Comparison compare_lambda(const RowAnalysis& rows, const VectorX<Scalar>& lambda_1,
                          const VectorX<Scalar>& lambda_2);

/// |E (lambda_1 - lambda_2)| / max(|E lambda_1|, |E lambda_2|, |E^-1 b|); 0 if no multiplier is unique.
template <class Scalar>
double lambda_distance(const RowAnalysis& rows, const VectorX<Scalar>& lambda_1,
                       const VectorX<Scalar>& lambda_2);

/// Accelerations, weighted by the square root of the metric's diagonal (mass_metric.hpp): all together, r''
/// alone and omega_bar' alone. The sizes are those of all accelerations in the three cases.
struct AccelerationComparison {
  Comparison all, r_ddot, omega_bar_dot;
};

/// Compares the accelerations of all bodies in the norms of `rows`.
template <class Scalar>
AccelerationComparison compare_accelerations(const RowAnalysis& rows, const PhysicalSolution<Scalar>& a,
                                             const PhysicalSolution<Scalar>& b);

/// Differences of accelerations [-], relative to the largest of the two solutions and of acceleration_bound
/// (row_norms.hpp).
struct AccelerationDistance {
  double all = 0, r_ddot = 0, omega_bar_dot = 0;
};

/// The relative differences of compare_accelerations().
template <class Scalar>
AccelerationDistance acceleration_distance(const RowAnalysis& rows, const PhysicalSolution<Scalar>& a,
                                           const PhysicalSolution<Scalar>& b);

}  // namespace trivium
