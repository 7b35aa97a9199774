#pragma once
/// Bounds of Q, gamma and the row gradients of a tangent system. Terms of a bound enter
/// by their magnitudes, so that they do not cancel. The bounds give the scale of a lambda that is a small
/// difference of large terms. The bounds of rows come from their features. Wrenches of effects are added with
/// their signs, and then the terms of effects that have add_load_bounds by magnitude.

#include <cmath>
#include <vector>

#include "constraints/constraint_row.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "formulations/r_omega.hpp"

namespace trivium {

namespace detail {

/// Computes the bounds of a mechanism at one state, in r-omega.
template <class Types>
class MagnitudeBounds {
 public:
  MagnitudeBounds(const Mechanism<double, Types>& mechanism, const MechanismState<double>& state)
      : mechanism_(mechanism),
        t_(state.t),
        body_(body_kinematics(to_coordinates<ROmega<double>>(mechanism, state, {}))) {}

  /// Bounds of |Q| [6 nb: N, N m]; the gyroscopic moment enters as |omega_bar|^2 |J_bar|.
  VectorX<double> forces() const {
    VectorX<double> Q = VectorX<double>::Zero(6 * mechanism_.nb());
    const auto wrenches = applied_wrenches(mechanism_, body_, t_);
    for (int b = 0; b < mechanism_.nb(); ++b) {
      const double omega = body_[b].omega_bar.norm();
      Q.segment<3>(6 * b) = wrenches[b].F.cwiseAbs();
      Q.segment<3>(6 * b + 3).array() =
          wrenches[b].n_bar.cwiseAbs().array() + omega * omega * mechanism_.bodies[b].inertia.norm();
    }
    std::vector<BodyMotion<double>> motion(body_.begin(), body_.end());
    mechanism_.effects.add_load_bounds({mechanism_.bodies, motion, t_},
                                       [&](int body, const Vector3<double>& F, const Vector3<double>& n_bar) {
                                         if (body == mechanism_.ground()) return;
                                         Q.segment<3>(6 * body) += F;
                                         Q.segment<3>(6 * body + 3) += n_bar;
                                       });
    return Q;
  }

  /// Adds the bounds of |gamma| and of the gradients of every row.
  void add_rows(Magnitudes& sizes) const {
    sizes.gamma.resize(mechanism_.nc());
    for (int k = 0; k < mechanism_.nc(); ++k) {
      const BodyPair pair = bodies_of(mechanism_.rows[k]);
      with_features(mechanism_.rows[k], body_[pair.i], body_[pair.j], t_,
                    [&](const auto& x, const auto& y, const Jet<double>& f) {
                      add_product(x.magnitude(), y.magnitude(), std::abs(f.f_tt), pair, k, sizes);
                    });
    }
  }

 private:
  using Body = ROmega<double>::Kinematics;

  static void add_product(const FeatureMagnitude<double>& x, const FeatureMagnitude<double>& y, double f_tt,
                          const BodyPair& pair, int k, Magnitudes& sizes) {
    sizes.gamma[k] = x.bias * y.value + x.value * y.bias + 2 * x.rate * y.rate + f_tt;
    sizes.rows.push_back({pair, x.r * y.value + x.value * y.r, x.rot_i * y.value + x.value * y.rot_i,
                          x.rot_j * y.value + x.value * y.rot_j});
  }

  const Mechanism<double, Types>& mechanism_;
  double t_;
  std::vector<Body> body_;
};

}  // namespace detail

/// Sets system.magnitudes, in which omega_bar enters by its norm. Two examples show why the values of Q and
/// gamma are not enough. If a body spins fast about an axis of symmetry, Q and gamma vanish, but p'' of r-p
/// contains |omega_bar|^2 p / 4, whose rounding remains. If the direction c of a row is nearly parallel to
/// the vector from the centre of mass to its point, the gradient in the rotations is a small difference in
/// every formulation.
template <class Types>
void add_magnitude_bounds(const Mechanism<double, Types>& mechanism, const MechanismState<double>& state,
                          TangentSystem& system) {
  const detail::MagnitudeBounds<Types> magnitude(mechanism, state);
  system.magnitudes.Q = magnitude.forces();
  magnitude.add_rows(system.magnitudes);
}

}  // namespace trivium
