#include "formulations/analysis/magnitude_bounds.hpp"

#include <cmath>

#include "bodies/point_offset.hpp"

namespace trivium {

namespace {

using V = Vector3<double>;

/// Bounds of a feature's value, rate, bias and gradients by magnitudes alone, nothing cancelling.
struct Magnitude {
  double value = 0, rate = 0, bias = 0;
  double r = 0, rot_i = 0, rot_j = 0;
};

class MagnitudeBounds {
 public:
  MagnitudeBounds(const Mechanism<double>& mechanism, const MechanismState<double>& state)
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
    for (const SpringDamper<double>& spring : mechanism_.effects.all<SpringDamper<double>>()) add(spring, Q);
    return Q;
  }

  /// |gamma| and the gradients of every row.
  void add_rows(Magnitudes& sizes) const {
    sizes.gamma.resize(mechanism_.nc());
    for (int k = 0; k < mechanism_.nc(); ++k) {
      const Row row = std::visit([&](const auto& c) { return of(c); }, mechanism_.rows[k]);
      sizes.gamma[k] = row.gamma;
      sizes.rows.push_back({bodies_of(mechanism_.rows[k]), row.r, row.rot_i, row.rot_j});
    }
  }

 private:
  using Body = ROmega<double>::Kinematics;

  struct Row {
    double gamma = 0, r = 0, rot_i = 0, rot_j = 0;
  };

  static Magnitude vector(const Body& body, const V& a_bar, End end) {
    const double omega = body.omega_bar.norm(), a = a_bar.norm();
    return {a, omega * a, omega * omega * a, 0, end == End::i ? a : 0, end == End::j ? a : 0};
  }
  Magnitude offset(const BodyPair& pair, const V& s_i, const V& s_j) const {
    const Magnitude i = vector(body_[pair.i], s_i, End::i), j = vector(body_[pair.j], s_j, End::j);
    return {point_offset(body_[pair.i], s_i, body_[pair.j], s_j).norm(),
            (body_[pair.j].r_dot - body_[pair.i].r_dot).norm() + i.rate + j.rate,
            i.bias + j.bias,
            1,
            i.rot_i,
            j.rot_j};
  }
  static Row product(const Magnitude& x, const Magnitude& y, double f_tt) {
    return {x.bias * y.value + x.value * y.bias + 2 * x.rate * y.rate + std::abs(f_tt),
            x.r * y.value + x.value * y.r, x.rot_i * y.value + x.value * y.rot_i,
            x.rot_j * y.value + x.value * y.rot_j};
  }
  Row of(const DP1<double>& c) const {
    return product(vector(body_[c.i], c.a_bar_i, End::i), vector(body_[c.j], c.a_bar_j, End::j),
                   c.f(t_).f_tt);
  }
  Row of(const TurningDP1<double>& c) const {
    const double rate = std::abs(c.alpha(t_).f_t) + body_[c.i].omega_bar.norm();
    return product({1, rate, rate * rate, 0, 1, 0}, vector(body_[c.j], c.a_bar_j, End::j), c.alpha(t_).f_tt);
  }
  Row of(const DP2<double>& c) const {
    return product(vector(body_[c.i], c.a_bar_i, End::i), offset(c, c.s_bar_i, c.s_bar_j), c.f(t_).f_tt);
  }
  Row of(const D<double>& c) const {
    const Magnitude d = offset(c, c.s_bar_i, c.s_bar_j);
    return product(d, d, c.f(t_).f_tt);
  }
  Row of(const CD<double>& c) const {
    return product({c.c.norm(), 0, 0, 0, 0, 0}, offset(c, c.s_bar_i, c.s_bar_j), c.f(t_).f_tt);
  }
  /// The parts of a tension, each pulling for itself.
  void add(const SpringDamper<double>& spring, VectorX<double>& Q) const {
    const auto &i = body_[spring.i], &j = body_[spring.j];
    const V d = point_offset(i, spring.s_bar_i, j, spring.s_bar_j);
    if (d.isZero(0)) return;  // it has no direction, and no force: else it is an error (spring_damper.hpp)
    const V d_dot = point_offset_rate(i, spring.s_bar_i, j, spring.s_bar_j);
    const double pull = spring.stiffness * (d.norm() + std::abs(spring.free_length)) +
                        std::abs(spring.damping * d.dot(d_dot) / d.norm()) + std::abs(spring.actuator(t_).f);
    const auto load = [&](int body, const V& s_bar) {
      if (body == mechanism_.ground()) return;
      Q.segment<3>(6 * body) += pull * d.normalized().cwiseAbs();
      const V arm = s_bar.cross(body_[body].A.transpose() * d.normalized());
      Q.segment<3>(6 * body + 3) += pull * arm.cwiseAbs();
    };
    load(spring.i, spring.s_bar_i);
    load(spring.j, spring.s_bar_j);
  }

  const Mechanism<double>& mechanism_;
  double t_;
  std::vector<Body> body_;
};

}  // namespace

void add_magnitude_bounds(const Mechanism<double>& mechanism, const MechanismState<double>& state,
                          TangentSystem& system) {
  const MagnitudeBounds magnitude(mechanism, state);
  system.magnitudes.Q = magnitude.forces();
  magnitude.add_rows(system.magnitudes);
}

}  // namespace trivium
