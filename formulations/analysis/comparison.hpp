#pragma once
/// How far two solutions of one scene are from each other: differences of lambda in the norm of E and of
/// accelerations in the mass metric, and what each is measured against. Decides the bound within which
/// formulations must agree: 100 u kappa.

#include <algorithm>

#include "formulations/analysis/row_analysis.hpp"
#include "formulations/solution.hpp"

namespace trivium {

/// Of the bound below: how many roundings each way to lambda is allowed, beside what kappa makes of one.
inline constexpr int bound_factor = 100;

/// The bound of a relative difference of lambda between two formulations in arithmetic of unit roundoff u:
/// 100 u kappa, what a system of condition number kappa may lose to rounding, times bound_factor. Differences
/// within cancellation() of it are rounding too.
inline double lambda_bound(double u, double kappa) { return bound_factor * u * kappa; }

/// A difference and what it may be measured against; all in one norm.
struct Comparison {
  double difference = 0, size_1 = 0, size_2 = 0, reference_size = 0;
  double size_uncancelled = 0;  ///< 0: not known

  /// Against the larger of the two, or what could cause either.
  double relative() const { return over(std::max({size_1, size_2, reference_size})); }
  /// The error of the first where the second is the truth.
  double error() const { return over(std::max(size_2, reference_size)); }
  /// How many times a quarter of what could cause it, nothing cancelling, exceeds the scale: 1 in an ordinary
  /// state, |omega_bar|^2 in units of the load where a symmetric body spins fast. Rounding grows with it.
  double cancellation() const {
    const double scale = std::max({size_1, size_2, reference_size});
    return size_uncancelled > 0 && scale > 0 ? std::max(1.0, size_uncancelled / (4 * scale)) : 1.0;
  }

 private:
  double over(double scale) const { return difference == 0 ? 0.0 : difference / scale; }
};

/// |E (lambda_1 - lambda_2)| beside |E lambda| and |E^-1 b|; differences and lambda over the unique rows.
/// What could cause lambda is taken over all rows: a row that carries nothing is measured against its
/// neighbours.
template <class Scalar>
Comparison compare_lambda(const RowAnalysis& rows, const VectorX<Scalar>& lambda_1,
                          const VectorX<Scalar>& lambda_2);

/// |E (lambda_1 - lambda_2)| / max(|E lambda|, |E^-1 b|); 0 where no multiplier is unique.
template <class Scalar>
double lambda_distance(const RowAnalysis& rows, const VectorX<Scalar>& lambda_1,
                       const VectorX<Scalar>& lambda_2);

/// Accelerations in the mass metric (mass_metric.hpp): all, and the shares of r'' and omega_bar', measured
/// against all.
struct AccelerationComparison {
  Comparison all, r_ddot, omega_bar_dot;
};

template <class Scalar>
AccelerationComparison compare_accelerations(const RowAnalysis& rows, const PhysicalSolution<Scalar>& a,
                                             const PhysicalSolution<Scalar>& b);

/// The differences relative to the larger of the accelerations, or of what Q and gamma could cause.
struct AccelerationDistance {
  double all = 0, r_ddot = 0, omega_bar_dot = 0;
};

template <class Scalar>
AccelerationDistance acceleration_distance(const RowAnalysis& rows, const PhysicalSolution<Scalar>& a,
                                           const PhysicalSolution<Scalar>& b);

}  // namespace trivium
