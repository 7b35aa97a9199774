#pragma once
/// The definitions of error_estimate.hpp, compiled in instances/ for float to Real50. Include this file
/// for a Scalar without an instance, and for your own formulations, constraints or effects.

#include <algorithm>

#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/comparison.hpp"
#include "formulations/printed/error_estimate.hpp"

namespace trivium {

namespace detail {

/// How much x depends on the choice of the omitted rows: the change of x that satisfies the dependent rows
/// too (in the least-squares sense), plus the change by which multipliers of minimum |E lambda| would satisfy
/// the equations of the bodies. Both are rounding errors if the rows are exactly dependent.
template <EquationsAsPrinted F, EquationsAsPrinted Higher>
VectorX<typename F::Scalar> ambiguity_of(const AugmentedSolver<F>& solver,
                                         const VectorX<typename F::Scalar>& x,
                                         const AugmentedEquations<Higher>& higher) {
  using S = typename F::Scalar;
  using H = typename Higher::Scalar;
  const VectorX<S> full = solver.expand(x), shared = solver.to_minimum_norm(full);
  const Eigen::Index nc = solver.equations().nc();
  // the minimum-norm multipliers differ from those of x by a vector N y, and change the bodies' equations by
  // Phi^T N y, which is 0 up to rounding if the rows are exactly dependent
  const VectorX<H> missed = higher.defect(scalar_cast<H>(full));
  VectorX<S> change = scalar_cast<S>(VectorX<H>(higher.defect(scalar_cast<H>(shared)) - missed));
  VectorX<S> dependent = VectorX<S>::Zero(nc);
  for (int k : solver.rows().dependent) dependent[k] = static_cast<S>(missed.tail(nc)[k]);
  change.tail(nc) = -solver.redundant_multipliers().disagreement(dependent);
  return solver.substitute(solver.reduce(change));
}

}  // namespace detail

template <EquationsAsPrinted F, EquationsAsPrinted Higher>
ErrorEstimate estimate_error(const AugmentedSolver<F>& solver, const VectorX<typename F::Scalar>& x,
                             const AugmentedEquations<Higher>& higher) {
  using S = typename F::Scalar;
  using H = typename Higher::Scalar;
  const RowAnalysis& rows = solver.rows();
  const PhysicalSolution<S> low = solver.accelerations_of(solver.expand(x));
  PhysicalSolution<H> reported;
  for (std::size_t b = 0; b < low.r_ddot.size(); ++b) {
    reported.r_ddot.push_back(scalar_cast<H>(low.r_ddot[b]));
    reported.omega_bar_dot.push_back(scalar_cast<H>(low.omega_bar_dot[b]));
  }
  reported.lambda = scalar_cast<H>(low.lambda);

  VectorX<H> better = higher.expand(scalar_cast<H>(x));
  PhysicalSolution<H> best = higher.accelerations_of(better), previous = best;
  ErrorEstimate last_correction;
  const auto error = [&rows](const PhysicalSolution<H>& found, const PhysicalSolution<H>& truth) {
    return ErrorEstimate{compare_lambda(rows, found.lambda, truth.lambda).error(),
                         compare_accelerations(rows, found, truth).all.error()};
  };
  const auto correct = [&](const VectorX<S>& step) {
    better += higher.expand(scalar_cast<H>(step));
    previous = best;
    best = higher.accelerations_of(better);
    return error(previous, best);
  };
  const double u = static_cast<double>(unit_roundoff<S>());
  // The error is known well enough if the last correction is at most 5 % of it, since the estimate adds this
  // correction. Four steps reach this share unless the factors in S have no correct digit.
  const auto is_settled = [u](double remaining, double found) { return remaining <= 0.05 * found + u; };
  bool settled = false;
  for (int step = 0; step < 4 && !settled; ++step) {
    last_correction = correct(solver.substitute(scalar_cast<S>(higher.reduce(higher.defect(better)))));
    const ErrorEstimate found = error(reported, best);
    settled = is_settled(last_correction.lambda, found.lambda) &&
              is_settled(last_correction.acceleration, found.acceleration);
  }
  const ErrorEstimate found = error(reported, best);
  ErrorEstimate ambiguity;
  if (!solver.redundant_multipliers().none()) ambiguity = correct(detail::ambiguity_of(solver, x, higher));
  // If the corrections do not shrink, or the estimate is of the size of the solution, the solution in the
  // next precision may be wrong as well: no digit is known. A relative error of 0.3 leaves less than one
  // digit.
  constexpr double no_digits = 0.3;
  const auto bounded_estimate = [&](double known, double remaining, double ambiguous) {
    // The factor 2 is a margin, chosen by experiment: without it, the neglected error of `best` can make the
    // estimate smaller than the error. A larger factor gives away digits.
    const double estimate = 2 * (known + remaining + ambiguous) + u;
    return settled && estimate < no_digits ? estimate : std::max(1 / u, known);
  };
  return {bounded_estimate(found.lambda, last_correction.lambda, ambiguity.lambda),
          bounded_estimate(found.acceleration, last_correction.acceleration, ambiguity.acceleration)};
}

}  // namespace trivium
