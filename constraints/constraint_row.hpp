#pragma once
/// The equations of one basic constraint in the coordinates of a formulation. A basic constraint is the dot
/// product of two features x and y (feature.hpp) minus f(t), hence
///
///     Phi = x . y - f        Phi_q = y^T x_q + x^T y_q        nu = f' - (x_t . y + x . y_t)
///     gamma = f'' - (x_bias . y + x . y_bias + 2 x' . y')
///
/// with Phi_q q' = nu and Phi_q q'' = gamma. These formulas hold for all basic constraints and formulations.
/// Haug (1989), section 9.4.

#include <variant>

#include "constraints/basic_constraint.hpp"
#include "constraints/feature.hpp"

namespace trivium {

/// One row of the constraint equations, with its Jacobian blocks for bodies i and j. Phi_rot is the
/// derivative by the n rotational coordinates of a body, in r-omega by a small rotation (body components).
/// The unit of Phi is the unit of the dot product: DP1 has none, D has m^2, DP2 and CD have m if their
/// vectors are dimensionless. nu has the unit of Phi per s, gamma per s^2.
template <class Scalar, int RotationalUnknowns>
struct ConstraintRow {
  using Translational = Matrix<Scalar, 1, 3>;
  using Rotational = Matrix<Scalar, 1, RotationalUnknowns>;

  Scalar phi{0}, nu{0}, gamma{0};  ///< Phi, and right sides of Phi_q q' = nu and Phi_q q'' = gamma
  Translational r_i = Translational::Zero(), r_j = Translational::Zero();  ///< Phi_r of i and j [1x3]
  Rotational rot_i = Rotational::Zero(), rot_j = Rotational::Zero();       ///< Phi_rot [1xn]
};

/// Returns use(x, y, f) with the features and f(t) of a basic constraint or of a variant of them.
template <BodyKinematics Body, class Constraint, class Use>
auto with_features(const Constraint& constraint, const Body& i, const Body& j, const typename Body::Scalar& t,
                   const Use& use) {
  if constexpr (requires { constraint.index(); })
    return std::visit([&](const auto& c) { return c.with_features(i, j, t, use); }, constraint);
  else
    return constraint.with_features(i, j, t, use);
}

/// Phi, nu, gamma and the Jacobian blocks of Phi = x . y - f.
template <class Row, class X, class Y, class Scalar>
Row product_row(const X& x, const Y& y, const Jet<Scalar>& f) {
  const Vector3<Scalar> a = x.value(), b = y.value();
  Row row;
  row.phi = a.dot(b) - f.f;
  row.nu = f.f_t - (x.drift_along(b) + y.drift_along(a));
  row.gamma = f.f_tt - (x.bias_along(b) + y.bias_along(a) + 2 * x.rate().dot(y.rate()));
  x.add_jacobian(b, row);
  y.add_jacobian(a, row);
  return row;
}

/// The complete ConstraintRow of one constraint between bodies i and j at time t [s].
template <class Constraint, BodyKinematics Body>
auto evaluate_row(const Constraint& constraint, const Body& i, const Body& j,
                  const typename Body::Scalar& t) {
  using Row = ConstraintRow<typename Body::Scalar, Body::rotational_unknowns>;
  return with_features(constraint, i, j, t,
                       [](const auto& x, const auto& y, const auto& f) { return product_row<Row>(x, y, f); });
}

/// Phi of one constraint.
template <class Constraint, BodyKinematics Body>
typename Body::Scalar row_position(const Constraint& constraint, const Body& i, const Body& j,
                                   const typename Body::Scalar& t) {
  using Scalar = typename Body::Scalar;
  return with_features(constraint, i, j, t, [](const auto& x, const auto& y, const Jet<Scalar>& f) {
    return Scalar(x.value().dot(y.value()) - f.f);
  });
}

/// Phi' = Phi_q q' - nu of one constraint, computed from the rates of the features without the Jacobian.
template <class Constraint, BodyKinematics Body>
typename Body::Scalar row_velocity(const Constraint& constraint, const Body& i, const Body& j,
                                   const typename Body::Scalar& t) {
  using Scalar = typename Body::Scalar;
  return with_features(constraint, i, j, t, [](const auto& x, const auto& y, const Jet<Scalar>& f) {
    return Scalar(x.rate().dot(y.value()) + x.value().dot(y.rate()) - f.f_t);
  });
}

/// Phi'' of one constraint for given accelerations of its bodies (BodyAcceleration), computed from the
/// accelerations of the features. Neither Jacobian row nor gamma is formed, so the value checks both.
template <class Constraint, BodyKinematics Body, class Acceleration>
typename Body::Scalar row_acceleration(const Constraint& constraint, const Body& i, const Body& j,
                                       const typename Body::Scalar& t, const Acceleration& on_i,
                                       const Acceleration& on_j) {
  using Scalar = typename Body::Scalar;
  return with_features(constraint, i, j, t, [&](const auto& x, const auto& y, const Jet<Scalar>& f) {
    return Scalar(x.acceleration(on_i, on_j).dot(y.value()) + x.value().dot(y.acceleration(on_i, on_j)) +
                  2 * x.rate().dot(y.rate()) - f.f_tt);
  });
}

}  // namespace trivium
