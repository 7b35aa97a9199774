#pragma once
/// The augmented system solved as printed: accelerations and lambda of one formulation at one state,
/// redundant rows and all, with an error estimate that sees the errors of forming the matrix as well as those
/// of solving it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "formulations/dense_solver.hpp"
#include "formulations/equations_of_motion.hpp"
#include "formulations/row_analysis.hpp"

namespace trivium {

/// What every formulation answers, in the same physical terms.
template <class Scalar>
struct PhysicalSolution {
  std::vector<Vector3<Scalar>> r_ddot;         ///< [m/s^2, global]
  std::vector<Vector3<Scalar>> omega_bar_dot;  ///< [rad/s^2, body frame]
  VectorX<Scalar> lambda;                      ///< one per row; non-unique ones of minimum |E lambda|
};

/// |E (lambda_1 - lambda_2)| / max(|E lambda|, |E^-1 b|); differences and lambda over the unique rows, 0
/// where there are none. What could cause lambda is taken over all rows: a row that carries nothing is
/// measured against its neighbours.
template <class Scalar>
double lambda_distance(const RowAnalysis& rows, const VectorX<Scalar>& lambda_1,
                       const VectorX<Scalar>& lambda_2) {
  double difference = 0, size_1 = 0, size_2 = 0, cause = 0;
  for (Eigen::Index k = 0; k < lambda_1.size(); ++k) {
    const double E = rows.E[k];
    if (E == 0) continue;
    const auto square = [](double x) { return x * x; };
    cause += square(rows.lambda_cause[k] / E);
    if (!rows.unique[k]) continue;
    difference += square(E * static_cast<double>(Scalar(lambda_1[k] - lambda_2[k])));
    size_1 += square(E * static_cast<double>(lambda_1[k]));
    size_2 += square(E * static_cast<double>(lambda_2[k]));
  }
  const double scale = std::sqrt(std::max({size_1, size_2, cause}));
  return difference == 0 ? 0.0 : std::sqrt(difference) / scale;
}

/// Differences of accelerations in the mass metric (row_analysis.hpp), relative to the larger of the
/// acceleration itself and what Q and gamma could cause: all, and the shares of r'' and omega_bar'.
struct AccelerationDistance {
  double all = 0, r_ddot = 0, omega_bar_dot = 0;
};

template <class Scalar>
AccelerationDistance acceleration_distance(const RowAnalysis& rows, const PhysicalSolution<Scalar>& a,
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
  const double scale = std::max(std::sqrt(std::max(size_a, size_b)), rows.acceleration_cause);
  const auto relative = [scale](double square) { return square == 0 ? 0.0 : std::sqrt(square) / scale; };
  return {relative(r + omega), relative(r), relative(omega)};
}

/// One formulation's augmented system at one state, redundant rows left out, and what a solution of it means.
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
    const MatrixX<S> K = system.matrix();
    const Eigen::Index fixed = K.rows() - system.nc;
    for (Eigen::Index k = 0; k < fixed; ++k) kept_.push_back(k);
    for (int k : rows.independent) kept_.push_back(fixed + k);
    matrix_ = K(kept_, kept_);
    right_side_ = system.right_side()(kept_);
    full_size_ = K.rows();
  }

  const EquationsOfMotion<F>& equations() const { return eom_; }
  const std::vector<BodyState<F>>& states() const { return states_; }
  const MatrixX<S>& matrix() const { return matrix_; }  ///< printed order, redundant rows left out
  const VectorX<S>& right_side() const { return right_side_; }

  /// The unknowns by name; lambda is 0 in redundant rows, or with `minimum_norm` of minimum norm among the
  /// equivalent.
  Unknowns<F> unknowns(const VectorX<S>& x, bool minimum_norm = true) const {
    VectorX<S> full = VectorX<S>::Zero(full_size_);
    full(kept_) = x;
    Unknowns<F> u = split_unknowns<F>(full, eom_.nb(), eom_.nc());
    if (minimum_norm) to_minimum_norm(rows_, u.lambda);
    return u;
  }

  PhysicalSolution<S> physical(const VectorX<S>& x) const {
    const Unknowns<F> u = unknowns(x);
    PhysicalSolution<S> out;
    for (int b = 0; b < eom_.nb(); ++b) {
      out.r_ddot.push_back(u.body[b].r_ddot);
      out.omega_bar_dot.push_back(F::to_angular_acceleration(eom_.body[b], u.body[b].q_ddot));
    }
    out.lambda = u.lambda;
    return out;
  }

  /// The residual of every body's own equations and of every row at x.
  MatrixFreeResidual residual(const VectorX<S>& x) const {
    return matrix_free_residual<F>(mechanism_, eom_, unknowns(x, false), rows_.redundant);
  }

 private:
  const Mechanism<S>& mechanism_;
  const RowAnalysis& rows_;
  std::vector<BodyState<F>> states_;
  EquationsOfMotion<F> eom_;
  std::vector<Eigen::Index> kept_;
  MatrixX<S> matrix_;
  VectorX<S> right_side_;
  Eigen::Index full_size_ = 0;
};

/// The same, factored.
template <Formulation F>
class AugmentedSolver : public AugmentedEquations<F> {
 public:
  using S = typename F::Scalar;

  AugmentedSolver(const Mechanism<S>& mechanism, const MechanismState<S>& state, const RowAnalysis& rows,
                  const ChartOptions& options = {})
      : AugmentedEquations<F>(mechanism, state, rows, options), solver_(this->matrix()) {}

  /// The unknowns in printed order, redundant rows left out.
  VectorX<S> solve() const { return solver_.solve(this->right_side()); }
  /// K^-1 b by the factors at hand, unrefined.
  VectorX<S> substitute(const VectorX<S>& b) const { return solver_.substitute(b); }

 private:
  DenseSolver<S> solver_;
};

struct ErrorEstimate {
  double lambda = 0, acceleration = 0;
};

/// How far a solution is from that of the same scene in exact arithmetic, relative, in the norms above.
///
/// The next rung of the precision ladder forms the same system from the same data; its residual at x sees
/// every error, those of forming K and b in S included. Substituted through the factors of S and repeated, it
/// gives the solution to well beyond S, and the distance to it is the error. Twice that distance, plus what
/// the last correction leaves in doubt, plus u, is reported.
template <Formulation F, Formulation Higher>
ErrorEstimate estimate_error(const AugmentedSolver<F>& solver, const VectorX<typename F::Scalar>& x,
                             const AugmentedEquations<Higher>& higher, const RowAnalysis& rows) {
  using S = typename F::Scalar;
  using H = typename Higher::Scalar;
  const PhysicalSolution<S> low = solver.physical(x);
  PhysicalSolution<H> reported;
  for (std::size_t b = 0; b < low.r_ddot.size(); ++b) {
    reported.r_ddot.push_back(scalar_cast<H>(low.r_ddot[b]));
    reported.omega_bar_dot.push_back(scalar_cast<H>(low.omega_bar_dot[b]));
  }
  reported.lambda = scalar_cast<H>(low.lambda);

  VectorX<H> better = scalar_cast<H>(x);
  PhysicalSolution<H> best = higher.physical(better), previous = best;
  ErrorEstimate doubt;
  const auto distance = [&rows](const PhysicalSolution<H>& a, const PhysicalSolution<H>& b) {
    return ErrorEstimate{lambda_distance(rows, a.lambda, b.lambda), acceleration_distance(rows, a, b).all};
  };
  for (int step = 0; step < 4; ++step) {
    const VectorX<H> residual = higher.right_side() - higher.matrix() * better;
    better += scalar_cast<H>(solver.substitute(scalar_cast<S>(residual)));
    previous = best;
    best = higher.physical(better);
    doubt = distance(best, previous);
    const ErrorEstimate found = distance(best, reported);
    if (doubt.lambda <= 0.05 * found.lambda && doubt.acceleration <= 0.05 * found.acceleration) break;
  }
  const ErrorEstimate found = distance(best, reported);
  const double u = static_cast<double>(unit_roundoff<S>());
  const auto honest = [u](double error, double remaining) {
    const double estimate = 2 * (error + remaining) + u;
    return std::isfinite(estimate) ? estimate : std::numeric_limits<double>::max();
  };
  return {honest(found.lambda, doubt.lambda), honest(found.acceleration, doubt.acceleration)};
}

}  // namespace trivium
