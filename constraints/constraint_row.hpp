#pragma once
/// The equations of one basic constraint in the coordinates of a formulation: Phi, its first and second
/// derivative, its Jacobian, nu and gamma. A basic constraint is a dot product of two features x and y
/// (feature.hpp); with them
///
///   Phi = x . y - f        Phi_q = y^T x_q + x^T y_q        nu = f' - Phi_t
///   gamma = f'' - (x_bias . y + x . y_bias + 2 x' . y')
///
/// so each is written once and holds in every formulation. Haug (1989), section 9.4.

#include <variant>

#include "constraints/basic_constraint.hpp"
#include "constraints/feature.hpp"

namespace trivium {

/// One row of the constraint equations in the coordinates of a formulation:
/// Phi_q q'' = gamma, Phi_q q' = nu, and its Jacobian blocks on bodies i and j.
template <class Scalar, int RotationalUnknowns>
struct ConstraintRow {
  using Translational = Matrix<Scalar, 1, 3>;
  using Rotational = Matrix<Scalar, 1, RotationalUnknowns>;

  Scalar phi{0}, nu{0}, gamma{0};
  Translational r_i = Translational::Zero(), r_j = Translational::Zero();
  Rotational rot_i = Rotational::Zero(), rot_j = Rotational::Zero();
};

/// Builds the two features and f of a constraint between bodies i and j at time t and hands them to `use(x,
/// y, f)`.
template <BodyKinematics Body, class Use>
struct FeaturePair {
  using Scalar = typename Body::Scalar;
  using VectorI = BodyVectorFeature<Body, End::i>;
  using VectorJ = BodyVectorFeature<Body, End::j>;
  using Offset = PointOffsetFeature<Body>;

  const Body& i;
  const Body& j;
  const Scalar& t;
  const Use& use;

  auto operator()(const DP1<Scalar>& c) const {
    return use(VectorI(i, c.a_bar_i), VectorJ(j, c.a_bar_j), c.f(t));
  }
  auto operator()(const TurningDP1<Scalar>& c) const {
    const auto [sine, cosine] = SineCosine<Scalar>(c.alpha.phase(t));
    const MovingVectorFeature<Body, End::i> w(i, -sine.f * c.u_bar_i + cosine.f * c.v_bar_i,
                                              -sine.f_t * c.u_bar_i + cosine.f_t * c.v_bar_i,
                                              -sine.f_tt * c.u_bar_i + cosine.f_tt * c.v_bar_i);
    return use(w, VectorJ(j, c.a_bar_j), Jet<Scalar>{});
  }
  auto operator()(const DP2<Scalar>& c) const {
    return use(VectorI(i, c.a_bar_i), Offset(i, c.s_bar_i, j, c.s_bar_j), c.f(t));
  }
  auto operator()(const D<Scalar>& c) const {
    const Offset d(i, c.s_bar_i, j, c.s_bar_j);
    return use(d, d, c.f(t));
  }
  auto operator()(const CD<Scalar>& c) const {
    return use(ConstantFeature<Scalar>{c.c}, Offset(i, c.s_bar_i, j, c.s_bar_j), c.f(t));
  }
};

template <BodyKinematics Body, class Use>
auto with_features(const BasicConstraint<typename Body::Scalar>& constraint, const Body& i, const Body& j,
                   const typename Body::Scalar& t, const Use& use) {
  return std::visit(FeaturePair<Body, Use>{i, j, t, use}, constraint);
}

/// Phi, nu, gamma and the Jacobian blocks of x . y - f.
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

/// The row of one constraint.
template <BodyKinematics Body>
auto evaluate_row(const BasicConstraint<typename Body::Scalar>& constraint, const Body& i, const Body& j,
                  const typename Body::Scalar& t) {
  using Row = ConstraintRow<typename Body::Scalar, Body::rotational_unknowns>;
  return with_features(constraint, i, j, t,
                       [](const auto& x, const auto& y, const auto& f) { return product_row<Row>(x, y, f); });
}

/// Phi of one constraint.
template <BodyKinematics Body>
typename Body::Scalar row_position(const BasicConstraint<typename Body::Scalar>& constraint, const Body& i,
                                   const Body& j, const typename Body::Scalar& t) {
  using Scalar = typename Body::Scalar;
  return with_features(constraint, i, j, t, [](const auto& x, const auto& y, const Jet<Scalar>& f) {
    return Scalar(x.value().dot(y.value()) - f.f);
  });
}

/// Phi' of one constraint, Phi_q q' - nu, from the features alone.
template <BodyKinematics Body>
typename Body::Scalar row_velocity(const BasicConstraint<typename Body::Scalar>& constraint, const Body& i,
                                   const Body& j, const typename Body::Scalar& t) {
  using Scalar = typename Body::Scalar;
  return with_features(constraint, i, j, t, [](const auto& x, const auto& y, const Jet<Scalar>& f) {
    return Scalar(x.rate().dot(y.value()) + x.value().dot(y.rate()) - f.f_t);
  });
}

/// Phi'' of one constraint under given accelerations of its bodies, from the features alone: no Jacobian, no
/// gamma.
template <BodyKinematics Body, class Acceleration>
typename Body::Scalar row_acceleration(const BasicConstraint<typename Body::Scalar>& constraint,
                                       const Body& i, const Body& j, const typename Body::Scalar& t,
                                       const Acceleration& on_i, const Acceleration& on_j) {
  using Scalar = typename Body::Scalar;
  return with_features(constraint, i, j, t, [&](const auto& x, const auto& y, const Jet<Scalar>& f) {
    return Scalar(x.acceleration(on_i, on_j).dot(y.value()) + x.value().dot(y.acceleration(on_i, on_j)) +
                  2 * x.rate().dot(y.rate()) - f.f_tt);
  });
}

}  // namespace trivium
