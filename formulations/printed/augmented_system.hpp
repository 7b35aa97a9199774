#pragma once
/// The augmented system of one formulation as printed in the textbooks: its dense blocks, its matrix and
/// right side, and its unknowns by name. Haug (1989), sections 11.2 and 11.3.

#include <vector>

#include "constraints/body_kinematics.hpp"
#include "formulations/equations_of_motion.hpp"

namespace trivium {

/// The augmented system as printed, in the order r'', q'', lambda_internal, lambda (r-p: r'', p'', lambda^p,
/// lambda):
///
///     [ M                     Phi_r^T  ] [ r''      ]   [ F              ]
///     [      J        P^T     Phi_rot^T] [ q''      ] = [ tau            ]
///     [      P                         ] [ lambda^p ]   [ gamma_internal ]
///     [ Phi_r  Phi_rot                 ] [ lambda   ]   [ gamma          ]
///
/// In the literature J, Phi_rot, tau, gamma are J^p, Phi_p, tau_hat, gamma_hat in r-p; J_bar, Phi_pi_bar,
/// n_bar - tilde(omega_bar) J_bar omega_bar, gamma in r-omega; and J^epsilon, Phi_epsilon, tau, gamma in
/// r-epsilon.
template <EquationsAsPrinted F>
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

/// Assembles the blocks of all bodies and rows; the ground has none.
template <EquationsAsPrinted F>
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

/// The unknowns of the augmented system by name, with accelerations r'' and q'' per body.
template <EquationsAsPrinted F>
struct Unknowns {
  using S = typename F::Scalar;
  std::vector<BodyAcceleration<S, F::rotational_unknowns>> body;  ///< nb + 1 entries; zero for the ground
  VectorX<S> lambda_internal, lambda;
};

/// Splits a full solution vector into its parts.
template <EquationsAsPrinted F>
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

}  // namespace trivium
