#pragma once
/// From mechanism + formulation + state: the equations of motion, body by body and row by row, and the
/// augmented system as printed in the books.

#include <cmath>
#include <string>
#include <vector>

#include "formulations/formulation.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// One body in a formulation's coordinates, in the chart chosen for it.
template <Formulation F>
struct BodyState {
  Vector3<typename F::Scalar> r, r_dot;
  typename F::Chart chart;
  typename F::Coordinates q;
};

/// The state of a mechanism in a formulation's coordinates; throws a ModelError that names the body whose
/// chart is singular.
template <Formulation F>
std::vector<BodyState<F>> to_coordinates(const Mechanism<typename F::Scalar>& mechanism,
                                         const MechanismState<typename F::Scalar>& state,
                                         const ChartOptions& options) {
  std::vector<BodyState<F>> bodies;
  bodies.reserve(mechanism.bodies.size());
  for (int b = 0; b < mechanism.nb(); ++b) {
    const auto& pose = state.pose[b];
    const auto& twist = state.twist[b];
    try {
      const typename F::Chart chart = F::choose_chart(options, pose.p);
      bodies.push_back({pose.r, twist.r_dot, chart, F::from_pose(chart, pose.p, twist.omega_bar)});
    } catch (const ModelError& error) {
      throw ModelError(fmt::format("body \"{}\": {}", mechanism.body_names[b], error.what()));
    }
  }
  return bodies;
}

/// The kinematics of all bodies, the ground's last.
template <Formulation F>
std::vector<typename F::Kinematics> body_kinematics(const std::vector<BodyState<F>>& bodies) {
  using S = typename F::Scalar;
  std::vector<typename F::Kinematics> kinematics;
  kinematics.reserve(bodies.size() + 1);
  for (const BodyState<F>& b : bodies) kinematics.push_back(F::kinematics(b.chart, b.r, b.r_dot, b.q));
  // the ground has no unknowns, so any regular chart serves it
  const Vector3<S> zero = Vector3<S>::Zero();
  const Vector4<S> upright = Vector4<S>::Unit(0);
  const typename F::Chart chart = F::choose_chart(ChartOptions{}, upright);
  kinematics.push_back(F::kinematics(chart, zero, zero, F::from_pose(chart, upright, zero)));
  // upright to the last bit: an angle of 90 degrees has none, and the ground's points may be far away
  kinematics.back().A.setIdentity();
  return kinematics;
}

/// The applied wrenches of all bodies, the ground's last.
template <class Kinematics, class Scalar>
std::vector<Wrench<Scalar>> applied_wrenches(const Mechanism<Scalar>& mechanism,
                                             const std::vector<Kinematics>& body, const Scalar& t) {
  const std::vector<BodyMotion<Scalar>> motion(body.begin(), body.end());
  std::vector<Wrench<Scalar>> wrenches(body.size());
  mechanism.effects.apply(EffectView<Scalar>{mechanism.bodies, motion, t}, wrenches);
  return wrenches;
}

/// All pieces of the equations of motion at one state.
template <Formulation F>
struct EquationsOfMotion {
  using S = typename F::Scalar;
  using Row = ConstraintRow<S, F::rotational_unknowns>;
  using Acceleration = BodyAcceleration<S, F::rotational_unknowns>;

  S t{0};
  std::vector<typename F::Kinematics> body;  ///< nb + 1, the ground last
  std::vector<S> mass;
  std::vector<Matrix<S, F::rotational_unknowns, F::rotational_unknowns>> mass_block;
  std::vector<Vector3<S>> F_applied;     ///< F
  std::vector<typename F::Unknown> tau;  ///< applied + velocity force of the rotational equations
  std::vector<BodyPair> pair;
  std::vector<Row> row;

  int nb() const { return static_cast<int>(mass.size()); }
  int nc() const { return static_cast<int>(row.size()); }
};

template <Formulation F>
EquationsOfMotion<F> equations_of_motion(const Mechanism<typename F::Scalar>& mechanism,
                                         const std::vector<BodyState<F>>& bodies,
                                         const typename F::Scalar& t) {
  EquationsOfMotion<F> eom;
  eom.t = t;
  eom.body = body_kinematics(bodies);
  const auto wrenches = applied_wrenches(mechanism, eom.body, t);
  for (int b = 0; b < mechanism.nb(); ++b) {
    const auto& J_bar = mechanism.bodies[b].inertia;
    eom.mass.push_back(mechanism.bodies[b].mass);
    eom.mass_block.push_back(F::mass_block(eom.body[b], J_bar));
    eom.F_applied.push_back(wrenches[b].F);
    eom.tau.push_back(F::applied_force(eom.body[b], wrenches[b].n_bar) +
                      F::velocity_force(eom.body[b], J_bar));
  }
  for (const auto& constraint : mechanism.rows) {
    const BodyPair pair = bodies_of(constraint);
    eom.pair.push_back(pair);
    eom.row.push_back(evaluate_row(constraint, eom.body[pair.i], eom.body[pair.j], t));
  }
  return eom;
}

/// The augmented system as printed, in the order r'', q'', lambda_internal, lambda (r-p: r'', p'', lambda^p,
/// lambda):
///
///   [ M                     Phi_r^T  ] [ r''      ]   [ F              ]
///   [      J        P^T     Phi_rot^T] [ q''      ] = [ tau            ]
///   [      P                         ] [ lambda^p ]   [ gamma_internal ]
///   [ Phi_r  Phi_rot                 ] [ lambda   ]   [ gamma          ]
///
/// J, Phi_rot, tau, gamma are the literature's J^p, Phi_p, tau_hat, gamma_hat in r-p (F::block_names has the
/// others').
template <Formulation F>
struct AugmentedSystem {
  using S = typename F::Scalar;
  int nb = 0, nc = 0;
  MatrixX<S> M, J, Phi_r, Phi_rot, P;
  VectorX<S> F_applied, tau, gamma_internal, gamma;

  Eigen::Index unknowns() const { return M.rows() + J.rows() + P.rows() + nc; }

  MatrixX<S> matrix() const {
    const Eigen::Index r = M.rows(), q = J.rows(), p = P.rows(), n = unknowns();
    MatrixX<S> K = MatrixX<S>::Zero(n, n);
    K.block(0, 0, r, r) = M;
    K.block(r, r, q, q) = J;
    K.block(r + q, r, p, q) = P;
    K.block(r, r + q, q, p) = P.transpose();
    K.block(r + q + p, 0, nc, r) = Phi_r;
    K.block(r + q + p, r, nc, q) = Phi_rot;
    K.block(0, r + q + p, r, nc) = Phi_r.transpose();
    K.block(r, r + q + p, q, nc) = Phi_rot.transpose();
    return K;
  }
  VectorX<S> right_side() const {
    VectorX<S> b(unknowns());
    b << F_applied, tau, gamma_internal, gamma;
    return b;
  }
};

template <Formulation F>
AugmentedSystem<F> augmented_system(const EquationsOfMotion<F>& eom) {
  using S = typename F::Scalar;
  constexpr int n = F::rotational_unknowns, m = F::internal_constraints;
  const int nb = eom.nb(), nc = eom.nc();
  AugmentedSystem<F> s;
  s.nb = nb;
  s.nc = nc;
  s.M = MatrixX<S>::Zero(3 * nb, 3 * nb);
  s.J = MatrixX<S>::Zero(n * nb, n * nb);
  s.P = MatrixX<S>::Zero(m * nb, n * nb);
  s.Phi_r = MatrixX<S>::Zero(nc, 3 * nb);
  s.Phi_rot = MatrixX<S>::Zero(nc, n * nb);
  s.F_applied.resize(3 * nb);
  s.tau.resize(n * nb);
  s.gamma_internal.resize(m * nb);
  s.gamma.resize(nc);
  for (int b = 0; b < nb; ++b) {
    s.M.template block<3, 3>(3 * b, 3 * b).diagonal().setConstant(eom.mass[b]);
    s.J.template block<n, n>(n * b, n * b) = eom.mass_block[b];
    s.P.template block<m, n>(m * b, n * b) = F::internal_jacobian(eom.body[b]);
    s.F_applied.template segment<3>(3 * b) = eom.F_applied[b];
    s.tau.template segment<n>(n * b) = eom.tau[b];
    s.gamma_internal.template segment<m>(m * b) = F::internal_gamma(eom.body[b]);
  }
  for (int k = 0; k < nc; ++k) {
    const auto& row = eom.row[k];
    const auto place = [&](int b, const auto& r, const auto& rot) {
      if (b == nb) return;
      s.Phi_r.template block<1, 3>(k, 3 * b) += r;
      s.Phi_rot.template block<1, n>(k, n * b) += rot;
    };
    place(eom.pair[k].i, row.r_i, row.rot_i);
    place(eom.pair[k].j, row.r_j, row.rot_j);
    s.gamma[k] = row.gamma;
  }
  return s;
}

/// Accelerations in a formulation's own unknowns, and the multipliers.
template <Formulation F>
struct Unknowns {
  using S = typename F::Scalar;
  std::vector<BodyAcceleration<S, F::rotational_unknowns>> body;  ///< nb + 1: the ground's are zero
  VectorX<S> lambda_internal, lambda;
};

/// Splits a solution vector of the augmented system.
template <Formulation F>
Unknowns<F> split_unknowns(const VectorX<typename F::Scalar>& x, int nb, int nc) {
  constexpr int n = F::rotational_unknowns, m = F::internal_constraints;
  Unknowns<F> u;
  u.body.resize(nb + 1);
  for (int b = 0; b < nb; ++b) {
    u.body[b].r_ddot = x.template segment<3>(3 * b);
    u.body[b].q_ddot = x.template segment<n>(3 * nb + n * b);
  }
  u.lambda_internal = x.segment((3 + n) * nb, m * nb);
  u.lambda = x.tail(nc);
  return u;
}

/// The matrix-free form: the residual of every body's own equations and of every row, nothing assembled. A
/// body's is relative to the sum of its terms' magnitudes; a row's to the sum of its own, with accelerations
/// as large as those terms could make them. Rows listed in `redundant` are measured apart.
struct MatrixFreeResidual {
  double bodies = 0, rows = 0, redundant_rows = 0;
};

template <Formulation F>
MatrixFreeResidual matrix_free_residual(const Mechanism<typename F::Scalar>& mechanism,
                                        const EquationsOfMotion<F>& eom, const Unknowns<F>& u,
                                        const std::vector<int>& redundant = {}) {
  using S = typename F::Scalar;
  using std::abs;
  const int nb = eom.nb();
  struct BodyBalance {
    Vector3<S> r = Vector3<S>::Zero();
    typename F::Unknown q = F::Unknown::Zero();
    S r_scale{0}, q_scale{0};
    void add_r(const Vector3<S>& term) {
      r += term;
      r_scale += term.norm();
    }
    void add_q(const typename F::Unknown& term) {
      q += term;
      q_scale += term.norm();
    }
  };
  std::vector<BodyBalance> balance(nb + 1);
  for (int b = 0; b < nb; ++b) {
    balance[b].add_r(eom.mass[b] * u.body[b].r_ddot);
    balance[b].add_r(-eom.F_applied[b]);
    balance[b].add_q(eom.mass_block[b] * u.body[b].q_ddot);
    balance[b].add_q(-eom.tau[b]);
    const Matrix<S, F::internal_constraints, F::rotational_unknowns> P = F::internal_jacobian(eom.body[b]);
    balance[b].add_q(P.transpose() * u.lambda_internal.template segment<F::internal_constraints>(
                                         F::internal_constraints * b));
  }
  MatrixFreeResidual residual;
  // a body at rest beside others that are not has terms that are their rounding: no scale of its own
  S largest(0);
  using std::sqrt;
  const S negligible = sqrt(unit_roundoff<S>());
  const auto raise = [&](double& worst, const S& value, const S& own_scale) {
    if (value == S(0)) return;
    const S least = negligible * largest, scale = own_scale < least ? least : own_scale;
    const double ratio = static_cast<double>(S(value / scale));
    if (std::isnan(ratio) || ratio > worst) worst = ratio;  // a NaN goes in and stays
  };
  std::vector<bool> is_redundant(mechanism.rows.size(), false);
  for (int k : redundant) is_redundant[k] = true;
  for (int k = 0; k < eom.nc(); ++k) {
    const auto [i, j] = eom.pair[k];
    const auto& row = eom.row[k];
    balance[i].add_r(u.lambda[k] * row.r_i.transpose());
    balance[i].add_q(u.lambda[k] * row.rot_i.transpose());
    balance[j].add_r(u.lambda[k] * row.r_j.transpose());
    balance[j].add_q(u.lambda[k] * row.rot_j.transpose());
  }
  // how large a body's accelerations are, or its forces could make them: those of a body at rest are rounding
  struct Reach {
    S r{0}, q{0};
  };
  std::vector<Reach> reach(nb + 1);
  for (int b = 0; b < nb; ++b) {
    reach[b] = {balance[b].r_scale / eom.mass[b], u.body[b].q_ddot.norm()};
    if (const S J = eom.mass_block[b].norm(); J > S(0)) reach[b].q += balance[b].q_scale / J;
  }
  std::vector<S> row_scale(eom.nc()), row_residual(eom.nc());
  for (int k = 0; k < eom.nc(); ++k) {
    const auto [i, j] = eom.pair[k];
    const auto& row = eom.row[k];
    const S phi_ddot =
        row_acceleration(mechanism.rows[k], eom.body[i], eom.body[j], eom.t, u.body[i], u.body[j]);
    row_residual[k] = abs(phi_ddot);
    row_scale[k] = abs(row.gamma) + row.r_i.norm() * reach[i].r + row.r_j.norm() * reach[j].r +
                   row.rot_i.norm() * reach[i].q + row.rot_j.norm() * reach[j].q;
    if (row_scale[k] > largest) largest = row_scale[k];
  }
  for (int k = 0; k < eom.nc(); ++k)
    raise(is_redundant[k] ? residual.redundant_rows : residual.rows, row_residual[k], row_scale[k]);
  largest = S(0);
  for (int b = 0; b < nb; ++b)
    for (const S& scale : {balance[b].r_scale, balance[b].q_scale})
      if (scale > largest) largest = scale;
  for (int b = 0; b < nb; ++b) {
    raise(residual.bodies, balance[b].r.norm(), balance[b].r_scale);
    raise(residual.bodies, balance[b].q.norm(), balance[b].q_scale);
  }
  return residual;
}

}  // namespace trivium
