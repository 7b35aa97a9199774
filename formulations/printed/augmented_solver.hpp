#pragma once
/// The augmented system solved as printed: accelerations and lambda of one formulation at one state,
/// redundant rows and all, with an error estimate that sees the errors of forming the matrix as well as those
/// of solving it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "formulations/analysis/row_analysis.hpp"
#include "formulations/printed/dense_solver.hpp"
#include "formulations/printed/redundant_multipliers.hpp"
#include "formulations/printed/residual.hpp"

namespace trivium {

/// What every formulation answers, in the same physical terms.
template <class Scalar>
struct PhysicalSolution {
  std::vector<Vector3<Scalar>> r_ddot;         ///< [m/s^2, global]
  std::vector<Vector3<Scalar>> omega_bar_dot;  ///< [rad/s^2, body frame]
  VectorX<Scalar> lambda;                      ///< one per row; non-unique ones of minimum |E lambda|
};

/// A difference and what it may be measured against; all in one norm.
struct Comparison {
  double difference = 0, size_1 = 0, size_2 = 0, cause = 0;
  double size_uncancelled = 0;  ///< 0: not known

  /// Against the larger of the two, or what could cause either.
  double relative() const { return over(std::max({size_1, size_2, cause})); }
  /// The error of the first where the second is the truth.
  double error() const { return over(std::max(size_2, cause)); }
  /// How many times a quarter of what could cause it, nothing cancelling, exceeds the scale: 1 in an ordinary
  /// state, |omega_bar|^2 in units of the load where a symmetric body spins fast. Rounding grows with it.
  double cancellation() const {
    const double scale = std::max({size_1, size_2, cause});
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
                          const VectorX<Scalar>& lambda_2) {
  double difference = 0, size_1 = 0, size_2 = 0, cause = 0, by_magnitude = 0;
  for (Eigen::Index k = 0; k < lambda_1.size(); ++k) {
    const double E = rows.E[k];
    if (E == 0) continue;
    const auto square = [](double x) { return x * x; };
    cause += square(rows.schur_rhs_bound[k] / E);
    if (rows.schur_rhs_bound_uncancelled.size() > 0)
      by_magnitude += square(rows.schur_rhs_bound_uncancelled[k] / E);
    if (!rows.unique[k]) continue;
    difference += square(E * static_cast<double>(Scalar(lambda_1[k] - lambda_2[k])));
    size_1 += square(E * static_cast<double>(lambda_1[k]));
    size_2 += square(E * static_cast<double>(lambda_2[k]));
  }
  return {std::sqrt(difference), std::sqrt(size_1), std::sqrt(size_2), std::sqrt(cause),
          std::sqrt(by_magnitude)};
}

/// |E (lambda_1 - lambda_2)| / max(|E lambda|, |E^-1 b|); 0 where no multiplier is unique.
template <class Scalar>
double lambda_distance(const RowAnalysis& rows, const VectorX<Scalar>& lambda_1,
                       const VectorX<Scalar>& lambda_2) {
  return compare_lambda(rows, lambda_1, lambda_2).relative();
}

/// Accelerations in the mass metric (row_analysis.hpp): all, and the shares of r'' and omega_bar', measured
/// against all.
struct AccelerationComparison {
  Comparison all, r_ddot, omega_bar_dot;
};

template <class Scalar>
AccelerationComparison compare_accelerations(const RowAnalysis& rows, const PhysicalSolution<Scalar>& a,
                                             const PhysicalSolution<Scalar>& b) {
  double r = 0, omega = 0, size_a = 0, size_b = 0;
  for (std::size_t n = 0; n < a.r_ddot.size(); ++n) {
    const auto weigh = [&](const Vector3<Scalar>& v, std::size_t offset) {
      return rows.acceleration_scale.segment<3>(static_cast<Eigen::Index>(6 * n + offset))
          .cwiseProduct(scalar_cast<double>(v))
          .squaredNorm();
    };
    r += weigh(a.r_ddot[n] - b.r_ddot[n], 0);
    omega += weigh(a.omega_bar_dot[n] - b.omega_bar_dot[n], 3);
    size_a += weigh(a.r_ddot[n], 0) + weigh(a.omega_bar_dot[n], 3);
    size_b += weigh(b.r_ddot[n], 0) + weigh(b.omega_bar_dot[n], 3);
  }
  const auto against_all = [&](double square) {
    return Comparison{std::sqrt(square), std::sqrt(size_a), std::sqrt(size_b), rows.acceleration_bound, 0};
  };
  return {against_all(r + omega), against_all(r), against_all(omega)};
}

/// The differences relative to the larger of the accelerations, or of what Q and gamma could cause.
struct AccelerationDistance {
  double all = 0, r_ddot = 0, omega_bar_dot = 0;
};

template <class Scalar>
AccelerationDistance acceleration_distance(const RowAnalysis& rows, const PhysicalSolution<Scalar>& a,
                                           const PhysicalSolution<Scalar>& b) {
  const AccelerationComparison c = compare_accelerations(rows, a, b);
  return {c.all.relative(), c.r_ddot.relative(), c.omega_bar_dot.relative()};
}

/// One formulation's augmented system at one state, and what a solution of it means. The system is solved
/// with its redundant rows left out: x is a solution of that reduced system, in printed order.
template <Formulation F>
class AugmentedEquations {
 public:
  using S = typename F::Scalar;

  AugmentedEquations(const Mechanism<S>& mechanism, const MechanismState<S>& state, const RowAnalysis& rows,
                     const ChartOptions& options = {})
      : mechanism_(mechanism),
        rows_(rows),
        states_(to_coordinates<F>(mechanism, state, options)),
        eom_(equations_of_motion<F>(mechanism, states_, state.t)) {
    const AugmentedSystem<F> system = augmented_system(eom_);
    K_ = system.matrix();
    b_ = system.right_side();
    const Eigen::Index fixed = K_.rows() - system.nc;
    for (Eigen::Index k = 0; k < fixed; ++k) kept_.push_back(k);
    for (int k : rows.independent) kept_.push_back(fixed + k);
  }

  const EquationsOfMotion<F>& equations() const { return eom_; }
  const std::vector<BodyState<F>>& states() const { return states_; }
  const RowAnalysis& rows() const { return rows_; }

  MatrixX<S> reduced_matrix() const { return rows_.redundant.empty() ? K_ : MatrixX<S>(K_(kept_, kept_)); }
  VectorX<S> reduced_right_side() const { return b_(kept_); }

  /// All unknowns, lambda 0 in redundant rows.
  VectorX<S> expand(const VectorX<S>& x) const {
    VectorX<S> full = VectorX<S>::Zero(K_.rows());
    full(kept_) = x;
    return full;
  }
  VectorX<S> reduce(const VectorX<S>& full) const { return full(kept_); }
  /// b - K x over all equations and unknowns, redundant rows among them.
  VectorX<S> defect(const VectorX<S>& full) const { return b_ - K_ * full; }
  /// The unknowns by name.
  Unknowns<F> split(const VectorX<S>& full) const { return split_unknowns<F>(full, eom_.nb(), eom_.nc()); }

  PhysicalSolution<S> accelerations_of(const VectorX<S>& full) const {
    const Unknowns<F> u = split(full);
    PhysicalSolution<S> out;
    for (int b = 0; b < eom_.nb(); ++b) {
      out.r_ddot.push_back(u.body[b].r_ddot);
      out.omega_bar_dot.push_back(F::to_angular_acceleration(eom_.body[b], u.body[b].q_ddot));
    }
    out.lambda = u.lambda;
    return out;
  }

  /// The residual of every body's own equations and of every row.
  MatrixFreeResidual residual(const VectorX<S>& full) const {
    return matrix_free_residual<F>(mechanism_, eom_, split(full), rows_.redundant);
  }

 private:
  const Mechanism<S>& mechanism_;
  const RowAnalysis& rows_;
  std::vector<BodyState<F>> states_;
  EquationsOfMotion<F> eom_;
  std::vector<Eigen::Index> kept_;
  MatrixX<S> K_;  ///< as printed, all rows
  VectorX<S> b_;
};

/// The same, factored.
template <Formulation F>
class AugmentedSolver : public AugmentedEquations<F> {
 public:
  using S = typename F::Scalar;

  AugmentedSolver(const Mechanism<S>& mechanism, const MechanismState<S>& state, const RowAnalysis& rows,
                  const ChartOptions& options = {})
      : AugmentedEquations<F>(mechanism, state, rows, options),
        solver_(this->reduced_matrix()),
        redundancy_(mechanism, state, rows) {}

  /// All unknowns in printed order, lambda of minimum norm among the equivalent.
  VectorX<S> solve() const { return to_minimum_norm(this->expand(solve_reduced())); }
  /// Redundant rows left out.
  VectorX<S> solve_reduced() const { return solver_.solve(this->reduced_right_side()); }
  /// The reduced K^-1 b by the factors at hand, unrefined.
  VectorX<S> substitute(const VectorX<S>& b) const { return solver_.substitute(b); }

  VectorX<S> to_minimum_norm(VectorX<S> full) const {
    VectorX<S> lambda = full.tail(this->equations().nc());
    redundancy_.to_minimum_norm(lambda);
    full.tail(lambda.size()) = lambda;
    return full;
  }
  const RedundantMultipliers<S>& redundancy() const { return redundancy_; }

 private:
  DenseSolver<S> solver_;
  RedundantMultipliers<S> redundancy_;
};

struct ErrorEstimate {
  double lambda = 0, acceleration = 0;
};

namespace detail {

/// How far x would move if the rows called redundant were met as well as the others, in the least-squares
/// sense, and if their multipliers' share acted on nothing exactly: what dropping just these rows decided.
template <Formulation F, Formulation Higher>
VectorX<typename F::Scalar> ambiguity(const AugmentedSolver<F>& solver, const VectorX<typename F::Scalar>& x,
                                      const AugmentedEquations<Higher>& higher) {
  using S = typename F::Scalar;
  using H = typename Higher::Scalar;
  const VectorX<S> full = solver.expand(x), shared = solver.to_minimum_norm(full);
  const Eigen::Index nc = solver.equations().nc();
  // with minimum-norm multipliers in place of x's the bodies' equations change by what Phi^T N keeps
  const VectorX<H> missed = higher.defect(scalar_cast<H>(full));
  VectorX<S> change = scalar_cast<S>(VectorX<H>(higher.defect(scalar_cast<H>(shared)) - missed));
  VectorX<S> redundant = VectorX<S>::Zero(nc);
  for (int k : solver.rows().redundant) redundant[k] = static_cast<S>(missed.tail(nc)[k]);
  change.tail(nc) = -solver.redundancy().disagreement(redundant);
  return solver.substitute(solver.reduce(change));
}

}  // namespace detail

/// How far a solution is from that of the same scene in exact arithmetic, relative, in the norms above.
///
/// The next rung of the precision ladder forms the same system from the same data; its residual at x sees
/// every error, those of forming K and b in S included. Substituted through the factors of S and repeated, it
/// gives the solution to well beyond S, and the distance to it is the error. Reported is twice the sum of
/// that distance, of what the last correction leaves in doubt and, where rows are redundant only to the
/// rounding of the scene's numbers, of what leaving out these rows and not others decided; plus u.
template <Formulation F, Formulation Higher>
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
  ErrorEstimate doubt;
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
  const auto is_settled = [u](double remaining, double found) { return remaining <= 0.05 * found + u; };
  bool settled = false;
  for (int step = 0; step < 4 && !settled; ++step) {
    doubt = correct(solver.substitute(scalar_cast<S>(higher.reduce(higher.defect(better)))));
    const ErrorEstimate found = error(reported, best);
    settled = is_settled(doubt.lambda, found.lambda) && is_settled(doubt.acceleration, found.acceleration);
  }
  const ErrorEstimate found = error(reported, best);
  ErrorEstimate undecided;
  if (!solver.redundancy().none()) undecided = correct(detail::ambiguity(solver, x, higher));
  // corrections that do not shrink lead nowhere, and a judge that finds the solution to be all error may be
  // no better himself: no digit is known
  constexpr double no_digits = 0.3;
  const auto honest = [&](double known, double remaining, double ambiguous) {
    const double estimate = 2 * (known + remaining + ambiguous) + u;
    return settled && estimate < no_digits ? estimate : std::max(1 / u, known);
  };
  return {honest(found.lambda, doubt.lambda, undecided.lambda),
          honest(found.acceleration, doubt.acceleration, undecided.acceleration)};
}

}  // namespace trivium
