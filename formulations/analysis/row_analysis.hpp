#pragma once
/// Which constraint rows are independent, which multipliers are unique, and in which norms errors are
/// measured. A property of the mechanism at one state, not of a formulation or of a precision: decided once,
/// in double, on the tangent Jacobian [Phi_r, Phi_pi_bar] whose columns are the bodies' velocities and
/// body-frame angular velocities.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "formulations/analysis/rank_tolerance.hpp"
#include "formulations/equations_of_motion.hpp"
#include "formulations/r_omega.hpp"
#include "mechanism/model.hpp"

namespace trivium {

/// A tangent system with every part of its entries by its own magnitude (cause_by_magnitude.hpp).
struct Magnitudes {
  /// One row: its bodies, |Phi_r|, and |Phi_pi_bar| on each.
  struct Row {
    BodyPair bodies;
    double r = 0, rot_i = 0, rot_j = 0;
  };
  VectorX<double> Q, gamma;
  std::vector<Row> rows;
};

/// The tangent system in double.
struct TangentSystem {
  std::vector<std::string> body_names;
  std::vector<double> mass;
  std::vector<Matrix3<double>> inertia;
  MatrixX<double> Phi;  ///< nc x 6 nb: a body's columns are r (3), then body-frame rotation (3)
  VectorX<double> Q;    ///< 6 nb: F; n_bar - tilde(omega_bar) Jbar omega_bar
  VectorX<double> gamma;
  Magnitudes magnitudes;  ///< empty: not known
};

/// The tangent system of a mechanism at a state, formed in Scalar.
template <class Scalar>
TangentSystem tangent_system(const Mechanism<Scalar>& mechanism, const MechanismState<Scalar>& state) {
  using F = ROmega<Scalar>;
  const auto eom = equations_of_motion<F>(mechanism, to_coordinates<F>(mechanism, state, {}), state.t);
  TangentSystem s;
  s.body_names = mechanism.body_names;
  s.Phi = MatrixX<double>::Zero(eom.nc(), 6 * eom.nb());
  s.Q.resize(6 * eom.nb());
  s.gamma.resize(eom.nc());
  for (int b = 0; b < eom.nb(); ++b) {
    s.mass.push_back(static_cast<double>(eom.mass[b]));
    s.inertia.push_back(scalar_cast<double>(eom.mass_block[b]));
    s.Q.segment<3>(6 * b) = scalar_cast<double>(eom.F_applied[b]);
    s.Q.segment<3>(6 * b + 3) = scalar_cast<double>(eom.tau[b]);
  }
  for (int k = 0; k < eom.nc(); ++k) {
    const auto& row = eom.row[k];
    const auto place = [&](int b, const auto& r, const auto& rot) {
      if (b == eom.nb()) return;
      s.Phi.block<1, 3>(k, 6 * b) += scalar_cast<double>(r);
      s.Phi.block<1, 3>(k, 6 * b + 3) += scalar_cast<double>(rot);
    };
    place(eom.pair[k].i, row.r_i, row.rot_i);
    place(eom.pair[k].j, row.r_j, row.rot_j);
    s.gamma[k] = static_cast<double>(row.gamma);
  }
  return s;
}

/// A symmetric positive definite metric of the tangent space: M, or where M is singular
/// M + Phi^T diag(mu) Phi. mu_k makes row k as heavy as the lighter of its bodies: the least of
/// m / |Phi_r|^2 and tr(Jbar) / |Phi_pi_bar|^2 over them, to the nearest power of two, so that the metric
/// depends neither on units nor on how a row is scaled (but for that rounding). Multipliers and accelerations
/// do not change with mu.
class Metric {
 public:
  /// Throws a ModelError that names the body and axis where [M; Phi] lacks full column rank.
  explicit Metric(const TangentSystem& system);

  /// One per row; all zero where M is regular.
  const VectorX<double>& mu() const { return mu_; }
  const VectorX<double>& diagonal() const { return diagonal_; }
  /// L^-1 x, where the metric is L L^T.
  MatrixX<double> half_solve(const MatrixX<double>& x) const;
  /// L^-T x.
  MatrixX<double> half_solve_transposed(const MatrixX<double>& x) const;

 private:
  void factor_blocks(const TangentSystem& system);
  void factor_augmented(const TangentSystem& system);

  VectorX<double> mu_, diagonal_;
  std::vector<Matrix3<double>> block_factor_;  ///< of Jbar, per body; used where M is regular
  VectorX<double> root_mass_;
  MatrixX<double> axes_, dense_factor_;  ///< where M is singular: principal axes, and the factor in them
};

struct RowAnalysis {
  int rank = 0;
  std::vector<int> independent, redundant;  ///< rows in file order; a redundant one depends on earlier rows
  std::vector<bool> unique;                 ///< row k of null(Phi^T) is zero: lambda_k is unique
  /// nc x (nc - rank): E N is orthonormal, Phi^T N = 0, zero in unique rows. lambda is unique up to N y. A
  /// row without a gradient has no column here; its lambda acts on nothing and is 0.
  MatrixX<double> null_basis;
  /// rank x 6 nb: the coefficients c of least |Phi_independent^T c - w| for a w; empty where no row is
  /// redundant.
  MatrixX<double> combination;
  /// Redundant rows whose right side contradicts that of the rows they follow from: no acceleration satisfies
  /// all.
  std::vector<int> contradictory;
  VectorX<double>
      E;  ///< diag(S)^(1/2), S = Phi M^-1 Phi^T: the norm of lambda, independent of units and of row scaling
  double kappa = 1;    ///< condition number of E^-1 S E^-1 over its nonzero singular values
  VectorX<double> mu;  ///< see Metric

  VectorX<double> schur_rhs_bound;  ///< b = |Phi| M^-1 |Q| + |gamma|
  /// The same in which nothing cancels (cause_by_magnitude.hpp); empty: not known.
  VectorX<double> schur_rhs_bound_uncancelled;
  VectorX<double> acceleration_scale;  ///< square root of the metric's diagonal, 6 nb
  double acceleration_bound = 0;  ///< the size of accelerations that Q and gamma could cause, in the metric
};

/// Where all that could cause lambda cancels, b is at least this share of what it would be if it did not:
/// what is left then is rounding, and no unit to measure lambda in.
inline constexpr double cancellation_floor = 1e-8;

RowAnalysis analyse_rows(const TangentSystem& system);

/// The row analysis and the printed form are dense: beyond this many unknowns (6 nb + nc) they take minutes
/// and gigabytes, and are refused.
inline constexpr int most_dense_unknowns = 6000;

/// The row analysis of a model, in double; throws a ModelError that names mechanism and time.
RowAnalysis analyse_rows(const Model<double>& model);

}  // namespace trivium
