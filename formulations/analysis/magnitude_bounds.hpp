#pragma once
/// What could cause lambda if nothing cancelled: bounds of Q, gamma and the rows' gradients in a tangent
/// system, by magnitudes alone. Decides in what unit a lambda is measured that is left of terms which cancel.
/// Rows follow from their features, effects say which of their parts may cancel.

#include <cmath>
#include <vector>

#include "constraints/constraint_row.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "formulations/r_omega.hpp"

namespace trivium {

namespace detail {

template <class Types>
class MagnitudeBounds {
 public:
  MagnitudeBounds(const Mechanism<double, Types>& mechanism, const MechanismState<double>& state)
      : mechanism_(mechanism),
        t_(state.t),
        body_(body_kinematics(to_coordinates<ROmega<double>>(mechanism, state, {}))) {}

  /// |Q| of one body: its rotational part alone holds the gyroscopic moment.
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

  /// |gamma| and the gradients of every row.
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

/// Sets the magnitudes of Q and gamma in a tangent system: every part of a force and of gamma by its own,
/// omega_bar by its norm. In a fast spin about an axis of symmetry Q and gamma vanish, but r-p carries
/// |omega_bar|^2 / 4 in its unknowns all the same, and its rounding is of that size; where c is nearly along
/// a lever, so is that of every formulation's gradient.
template <class Types>
void add_magnitude_bounds(const Mechanism<double, Types>& mechanism, const MechanismState<double>& state,
                          TangentSystem& system) {
  const detail::MagnitudeBounds<Types> magnitude(mechanism, state);
  system.magnitudes.Q = magnitude.forces();
  magnitude.add_rows(system.magnitudes);
}

}  // namespace trivium
