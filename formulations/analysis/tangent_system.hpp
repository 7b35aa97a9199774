#pragma once
/// The equations of a mechanism at one state in the tangent space, in double: mass, forces, and the Jacobian
/// [Phi_r, Phi_pi_bar], whose columns belong to the velocities and the body-frame angular velocities of the
/// bodies. They are the same for every formulation.

#include <string>
#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "formulations/equations_of_motion.hpp"
#include "formulations/r_omega.hpp"

namespace trivium {

/// Bounds of Q, gamma and the row gradients, whose terms enter by their magnitudes (magnitude_bounds.hpp).
struct Magnitudes {
  /// One row: its bodies, a bound of |Phi_r|, and bounds of |Phi_pi_bar| on each body.
  struct Row {
    BodyPair bodies;
    double r = 0, rot_i = 0, rot_j = 0;
  };
  VectorX<double> Q, gamma;
  std::vector<Row> rows;
};

/// Mass [kg], inertia J_bar [kg m^2], forces, Jacobian and gamma in double.
struct TangentSystem {
  std::vector<std::string> body_names;
  std::vector<double> mass;
  std::vector<Matrix3<double>> inertia;
  MatrixX<double> Phi;  ///< [nc x 6 nb]; columns of a body: r (3), then body-frame rotation (3)
  VectorX<double> Q;    ///< [6 nb]: F; n_bar - tilde(omega_bar) J_bar omega_bar
  VectorX<double> gamma;
  Magnitudes magnitudes;  ///< empty if not computed
  double rank_tolerance = standard_rank_tolerance;
};

/// The tangent system of a mechanism at a state, computed in Scalar and rounded to double.
template <class Scalar, class Types>
TangentSystem tangent_system(const Mechanism<Scalar, Types>& mechanism, const MechanismState<Scalar>& state) {
  using F = ROmega<Scalar>;
  const auto eom = equations_of_motion<F>(mechanism, to_coordinates<F>(mechanism, state, {}), state.t);
  TangentSystem s;
  s.body_names = mechanism.body_names;
  s.rank_tolerance = mechanism.rank_tolerance;
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

}  // namespace trivium
