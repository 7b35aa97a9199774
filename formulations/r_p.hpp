#pragma once
/// r-p: the unknowns of a body are r'' and the second derivative p'' of its four Euler parameters
/// p = (e0, e). One internal row per body, the normalisation row, keeps p a unit vector. Haug (1989),
/// section 11.3; J^p, P, tau_hat, gamma^p as in Negrut, ME 751: Advanced Computational Multibody Dynamics
/// (lecture notes, University of Wisconsin-Madison):
///
///     m r'' + Phi_r^T lambda = F
///     J^p p'' + Phi_p^T lambda + P^T lambda^p = tau_hat
///     P p'' = gamma^p
///
/// The row is (p . p - 1)/2 = 0, so P = p^T and gamma^p = -p' . p'. Some lecture notes combine this P
/// with gamma^p = -2 p' . p', which belongs to the row p . p - 1 = 0. The resulting p'' has a wrong part
/// along p. Because J^p p = 0, this part has no effect on rows with Phi_p p = 0 (dp1 of perpendicular
/// vectors), which hides the error; with other rows omega_bar' and lambda are wrong. The multiplier lambda^p
/// depends on how the function A(p) continues off the unit sphere; here A = E G^T. Between codes, compare
/// lambda, not lambda^p.

#include "bodies/rigid_body.hpp"
#include "bodies/rotations/so3.hpp"
#include "constraints/body_kinematics.hpp"
#include "formulations/formulation.hpp"

namespace trivium {

/// The formulation r-p; formulation.hpp lists the contract of its members.
template <class S>
struct RP {
  using Scalar = S;
  using Unknown = Vector4<S>;

  // constants
  static constexpr std::string_view name = "r-p";
  static constexpr int rotational_unknowns = 4;
  static constexpr int internal_constraints = 1;
  static constexpr int orientation_size = 4;
  using Orientation = Vector4<S>;

  using Chart = NoChart;

  /// Euler parameters p [-] and their rates p' [1/s].
  struct Coordinates {
    Vector4<S> p = Vector4<S>::Unit(0), p_dot = Vector4<S>::Zero();
  };

  /// B(p, a_bar) = 2 [(e0 I + tilde e) a_bar, e a_bar^T - (e0 I + tilde e) tilde(a_bar)] [3x4], linear in p:
  /// (A a_bar)' = B(p, a_bar) p'.
  static Matrix<S, 3, 4> B(const Vector4<S>& p, const Vector3<S>& a_bar) {
    const Matrix3<S> block = euler_parameter_block(p);
    Matrix<S, 3, 4> b;
    b.col(0) = block * a_bar;
    b.template rightCols<3>() = p.template tail<3>() * a_bar.transpose() - times_tilde<S>(block, a_bar);
    return 2 * b;
  }

  // orientation: A = E G^T
  /// Motion of a body and of the vectors fixed in it; a model of the concept BodyKinematics.
  struct Kinematics : BodyMotion<S> {
    using Scalar = S;
    static constexpr int rotational_unknowns = 4;
    Vector4<S> p, p_dot;  ///< p [-] and p' [1/s]
    Matrix<S, 3, 4> G;    ///< G(p): omega_bar = 2 G p'

    /// a = A a_bar, its rate B(p, a_bar) p' = 2 E G'^T a_bar, and its bias B(p', a_bar) p' = 2 E' G'^T a_bar:
    /// a'' at p'' = 0.
    BodyVector<S> vector(const Vector3<S>& a_bar) const {
      const Vector4<S> g = 2 * (G_matrix(p_dot).transpose() * a_bar);
      return {a_bar, this->A * a_bar, E_matrix(p) * g, E_matrix(p_dot) * g};
    }
    /// B(p, a_bar) [3x4].
    Matrix<S, 3, 4> jacobian(const BodyVector<S>& v) const { return B(p, v.a_bar); }
    /// w^T B [1x4].
    Matrix<S, 1, 4> jacobian_along(const BodyVector<S>& v, const Vector3<S>& w) const {
      const Vector3<S> e = p.template tail<3>(), y = p[0] * w - e.cross(w);
      Matrix<S, 1, 4> row;
      row[0] = y.dot(v.a_bar);
      row.template tail<3>() = (w.dot(e) * v.a_bar + v.a_bar.cross(y)).transpose();
      return 2 * row;
    }
  };
  static Kinematics kinematics(const Chart&, const Vector3<S>& r, const Vector3<S>& r_dot,
                               const Coordinates& q) {
    const Matrix<S, 3, 4> G = G_matrix(q.p);
    return {BodyMotion<S>{r, r_dot, E_matrix(q.p) * G.transpose(), 2 * G * q.p_dot}, q.p, q.p_dot, G};
  }

  // mass block: J^p = 4 G^T J_bar G [4x4], of rank 3: J^p p = 0
  static Matrix<S, 4, 4> mass_block(const Kinematics& k, const Matrix3<S>& J_bar) {
    return 4 * k.G.transpose() * J_bar * k.G;
  }

  // quadratic-velocity force: 8 G'^T J_bar G' p
  static Unknown velocity_force(const Kinematics& k, const Matrix3<S>& J_bar) {
    const Matrix<S, 3, 4> G_dot = G_matrix(k.p_dot);
    return 8 * (G_dot.transpose() * (J_bar * (G_dot * k.p)));
  }
  static Unknown applied_force(const Kinematics& k, const Vector3<S>& n_bar) {
    return 2 * k.G.transpose() * n_bar;
  }

  // internal constraint row: P = p^T, gamma^p = -p' . p'
  static Matrix<S, 1, 4> internal_jacobian(const Kinematics& k) { return k.p.transpose(); }
  static Vector<S, 1> internal_gamma(const Kinematics& k) { return Vector<S, 1>(-k.p_dot.squaredNorm()); }

  // reduced equations (internal row eliminated): x = omega_bar'
  /// Kinematics with the unknown x: p'' = 1/2 G^T x - |p'|^2 p satisfies the internal row for every x, where
  /// p is taken as a unit vector. The reduced mass block is (1/2 G) J^p (1/2 G^T) = J_bar, so x is
  /// omega_bar'.
  struct Reduced : Kinematics {
    static constexpr int rotational_unknowns = 3;

    /// The bias is a'' at x = 0: B(p', a_bar) p' - |p'|^2 B(p, a_bar) p, where the two terms cancel at a fast
    /// spin and leave a rounding error of u |omega|^2. Their sum for unit p is A tilde(omega_bar)^2 a_bar
    /// with omega_bar = 2 G p'. Like the other reduced terms it is a closed form for unit p; in the printed
    /// form only the bias would lose digits.
    BodyVector<S> vector(const Vector3<S>& a_bar) const {
      const Vector4<S> g = 2 * (G_matrix(this->p_dot).transpose() * a_bar);
      return {a_bar, this->A * a_bar, E_matrix(this->p) * g,
              this->A * this->omega_bar.cross(this->omega_bar.cross(a_bar))};
    }
    /// B(p, a_bar) 1/2 G^T = -A tilde(a_bar) for unit p.
    Matrix3<S> jacobian(const BodyVector<S>& v) const { return -times_tilde<S>(this->A, v.a_bar); }
    Matrix<S, 1, 3> jacobian_along(const BodyVector<S>& v, const Vector3<S>& w) const {
      return v.a_bar.cross(Vector3<S>(this->A.transpose() * w)).transpose();
    }
  };
  static constexpr bool reduced_mass_is_constant = true;  // of reduced_mass_block [3x3]
  static AngularMotion<S> angular_motion(const Reduced& k) {
    return {k.A, k.A, k.A * k.omega_bar, Vector3<S>::Zero()};
  }
  static Matrix3<S> reduced_mass_block(const Kinematics&, const Matrix3<S>& J_bar) { return J_bar; }
  /// 1/2 G tau_hat = n_bar - tilde(omega_bar) J_bar omega_bar.
  static Vector3<S> reduced_force(const Kinematics& k, const Matrix3<S>& J_bar, const Vector3<S>& n_bar) {
    return n_bar - k.omega_bar.cross(J_bar * k.omega_bar);
  }
  static Unknown from_reduced(const Kinematics& k, const Vector3<S>& x) {
    return increment(k, x) - k.p_dot.squaredNorm() * k.p;
  }
  static Unknown increment(const Kinematics& k, const Vector3<S>& x) { return k.G.transpose() * x / 2; }
  static Vector3<S> omega_bar_dot_from_reduced(const Kinematics&, const Vector3<S>& x) { return x; }

  // unknown and angular acceleration: omega_bar' = 2 G p'', p'' = 1/2 G^T omega_bar' - 1/4 |omega_bar|^2 p
  static Matrix<S, 4, 3> lift(const Kinematics& k) { return k.G.transpose() / 2; }
  static Vector3<S> to_angular_acceleration(const Kinematics& k, const Unknown& p_ddot) {
    return 2 * k.G * p_ddot;
  }

  // orientation in an integrator: p, with the rate p'. Retraction: p + increment, scaled to unit length
  static Orientation orientation_of(const Chart&, const Vector4<S>& p) { return p; }
  static Unknown velocity_of(const Chart&, const Coordinates& q) { return q.p_dot; }
  static Coordinates from_orientation(const Chart&, const Orientation& p, const Unknown& p_dot) {
    return {p, p_dot};
  }
  static Orientation orientation_rate(const Chart&, const Orientation&, const Unknown& p_dot) {
    return p_dot;
  }
  static Orientation retract(const Chart&, const Orientation& p, const Unknown& increment) {
    const Orientation moved = p + increment;
    return moved / moved.norm();
  }
  static void normalise(Orientation& p, Unknown& p_dot) {
    p /= p.norm();
    p_dot -= p.dot(p_dot) * p;
  }

  // steps of implicit methods: p and p' are added as plain vectors, also off the unit sphere. The normalise
  // functions bring them back onto the internal row: a change c of p'' changes p (or p') by share * c
  static Orientation step(const Chart&, const Orientation& p, const Unknown& change) { return p + change; }
  static Unknown displacement(const Chart&, const Orientation& from, const Orientation& to) {
    return to - from;
  }
  static Unknown displacement_rate(const Unknown&, const Unknown& p_dot) { return p_dot; }
  static void normalise_step(Orientation& p, const S& share, Unknown& p_ddot) {
    const S size = p.norm();
    p /= size;
    p_ddot += (1 - size) / share * p;
  }
  static void normalise_step_velocity(const Orientation& p, const Unknown& p_dot, const S& share,
                                      Unknown& p_ddot) {
    p_ddot -= p.dot(p_dot) / (share * p.squaredNorm()) * p;
  }
  static constexpr bool inertia_is_constant = false;  // of mass_block [4x4], which depends on p
  // generalized forces in the reduced unknowns (1/2 G removes the part along p), and as a moment [N m, body
  // frame]
  static Vector3<S> reduced(const Reduced& k, const Unknown& force) { return k.G * force / 2; }
  static Vector3<S> moment(const Reduced&, const Vector3<S>& n_bar) { return n_bar; }

  // conversion from and to a pose: p' = 1/2 G^T omega_bar
  static S chart_distance(const Chart&, const Coordinates&) { return S(1); }
  static Chart choose_chart(const ChartOptions&, const Vector4<S>&) { return {}; }
  static Coordinates from_pose(const Chart&, const Vector4<S>& p, const Vector3<S>& omega_bar) {
    return {p, G_matrix(p).transpose() * omega_bar / 2};
  }
  static Vector4<S> to_euler_parameters(const Chart&, const Coordinates& q) { return q.p; }
};

static_assert(Formulation<RP<double>>);

}  // namespace trivium
