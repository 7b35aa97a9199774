#pragma once
/// The four basic constraints, each a dot product of two features (Haug 1989, section 9.4; equations below):
///
///   DP1  a_i . a_j - f(t)      DP2  a_i . d_ij - f(t)      D  d_ij . d_ij - f(t)      CD  c . d_ij - f(t)
///
/// and DP1 with a vector that turns by itself in body i (rotation drivers). With features x and y,
///
///   Phi = x . y - f        Phi_q = y^T x_q + x^T y_q        nu = f' - Phi_t
///   gamma = f'' - (x_bias . y + x . y_bias + 2 x' . y')
///
/// so each is written once and holds in every formulation.

#include <string>
#include <variant>

#include "bodies/numbers/time_function.hpp"
#include "constraints/feature.hpp"

namespace trivium {

/// The bodies of a row: indices into the mechanism's bodies, the last of which is the ground.
struct BodyPair {
  int i = 0, j = 0;
};

template <class Scalar>
struct DP1 : BodyPair {
  Vector3<Scalar> a_bar_i, a_bar_j;
  TimeFunction f;
};

/// DP1 whose first vector is w_i(t) = -sin alpha(t) u_i + cos alpha(t) v_i, f = 0.
template <class Scalar>
struct TurningDP1 : BodyPair {
  Vector3<Scalar> u_bar_i, v_bar_i, a_bar_j;
  TimeFunction alpha;
};

template <class Scalar>
struct DP2 : BodyPair {
  Vector3<Scalar> a_bar_i, s_bar_i, s_bar_j;
  TimeFunction f;
};

template <class Scalar>
struct D : BodyPair {
  Vector3<Scalar> s_bar_i, s_bar_j;
  TimeFunction f;
};

template <class Scalar>
struct CD : BodyPair {
  Vector3<Scalar> c, s_bar_i, s_bar_j;
  TimeFunction f;
};

template <class Scalar>
using BasicConstraint = std::variant<DP1<Scalar>, TurningDP1<Scalar>, DP2<Scalar>, D<Scalar>, CD<Scalar>>;

/// f(t), or alpha(t) of a turning vector.
template <class Scalar>
const TimeFunction& function_of(const BasicConstraint<Scalar>& constraint) {
  return std::visit(
      [](const auto& c) -> const TimeFunction& {
        if constexpr (requires { c.alpha; })
          return c.alpha;
        else
          return c.f;
      },
      constraint);
}

template <class Scalar>
BodyPair bodies_of(const BasicConstraint<Scalar>& constraint) {
  return std::visit([](const BodyPair& pair) { return pair; }, constraint);
}

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

/// How much Phi of one constraint, where it holds, changes per metre of its points or radian of its vectors:
/// |a_i| |a_j| (DP1), |a_i| (DP2), 2 |d| (D), |c| (CD); 1 where that is zero.
template <class Scalar>
Scalar row_scale(const BasicConstraint<Scalar>& constraint, const Scalar& t) {
  using std::sqrt, std::abs;
  struct Scale {
    const Scalar& t;
    Scalar operator()(const DP1<Scalar>& c) const { return c.a_bar_i.norm() * c.a_bar_j.norm(); }
    Scalar operator()(const TurningDP1<Scalar>& c) const { return c.u_bar_i.norm() * c.a_bar_j.norm(); }
    Scalar operator()(const DP2<Scalar>& c) const { return c.a_bar_i.norm(); }
    Scalar operator()(const D<Scalar>& c) const { return 2 * sqrt(abs(c.f(t).f)); }
    Scalar operator()(const CD<Scalar>& c) const { return c.c.norm(); }
  };
  const Scalar scale = std::visit(Scale{t}, constraint);
  return scale > Scalar(0) ? scale : Scalar(1);
}

/// Whether Phi, over its scale, is an angle [rad]; a length [m] where it is not.
template <class Scalar>
bool is_of_angle(const BasicConstraint<Scalar>& constraint) {
  return std::holds_alternative<DP1<Scalar>>(constraint) ||
         std::holds_alternative<TurningDP1<Scalar>>(constraint);
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
