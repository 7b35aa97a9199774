#pragma once
/// Completes a formulation F that defines only the equations as printed: ReducedToRotation adds the reduced
/// equations and the moving coordinates, with the unknown x = omega_bar' and the motion of r-omega. With
/// q'' = lift x + q_0, where q_0 satisfies the internal rows and has no angular acceleration,
///
///     lift^T mass_block lift x + (Phi_rot lift)^T lambda
///         = lift^T (applied_force + velocity_force - mass_block q_0)
///
/// All terms are computed from the printed functions of F. A formulation that defines the two parts itself
/// is faster and agrees with this one to rounding.

#include <type_traits>

#include "bodies/rigid_body.hpp"
#include "formulations/contract/equations_as_printed.hpp"
#include "formulations/r_omega.hpp"

namespace trivium {

/// A formulation with all three parts, made from the first part of F. The coordinates are those of F; an
/// integrator holds p and omega_bar, as for r-omega.
template <EquationsAsPrinted F>
struct ReducedToRotation {
  using Scalar = typename F::Scalar;
  using S = Scalar;
  using Types = MechanismTypesOf<F>;
  using Unknown = Vector3<S>;
  using Turns = ROmega<S>;

  // constants
  static constexpr std::string_view name = F::name;
  static constexpr int rotational_unknowns = 3;
  static constexpr int internal_constraints = 0;
  static constexpr int orientation_size = Turns::orientation_size;
  using Orientation = typename Turns::Orientation;

  using Chart = typename F::Chart;
  using Coordinates = typename F::Coordinates;

  /// Motion of a body and of the vectors fixed in it, from the printed kinematics of F with q'' = lift x +
  /// q_0.
  struct Kinematics : BodyMotion<S> {
    using Scalar = S;
    static constexpr int rotational_unknowns = 3;
    typename F::Kinematics printed;
    Matrix<S, F::rotational_unknowns, 3> lift;
    typename F::Unknown q_0;

    BodyVector<S> vector(const Vector3<S>& a_bar) const {
      BodyVector<S> v = printed.vector(a_bar);
      v.bias += printed.jacobian(v) * q_0;
      return v;
    }
    Matrix3<S> jacobian(const BodyVector<S>& v) const { return printed.jacobian(v) * lift; }
    Matrix<S, 1, 3> jacobian_along(const BodyVector<S>& v, const Vector3<S>& w) const {
      return printed.jacobian_along(v, w) * lift;
    }
  };
  static Kinematics kinematics(const Chart& chart, const Vector3<S>& r, const Vector3<S>& r_dot,
                               const Coordinates& q) {
    const typename F::Kinematics printed = F::kinematics(chart, r, r_dot, q);
    const Matrix<S, F::rotational_unknowns, 3> lift = F::lift(printed);
    typename F::Unknown q_0 = F::Unknown::Zero();
    if constexpr (F::internal_constraints > 0) {
      // the q'' of minimum norm that satisfies the internal rows; below, its angular acceleration is removed
      const Matrix<S, F::internal_constraints, F::rotational_unknowns> P = F::internal_jacobian(printed);
      q_0 = P.transpose() * (P * P.transpose()).inverse() * F::internal_gamma(printed);
    }
    q_0 -= lift * F::to_angular_acceleration(printed, q_0);
    return {BodyMotion<S>(printed), printed, lift, q_0};
  }

  static Matrix3<S> mass_block(const Kinematics& k, const Matrix3<S>& J_bar) {
    return k.lift.transpose() * F::mass_block(k.printed, J_bar) * k.lift;
  }
  static Unknown velocity_force(const Kinematics& k, const Matrix3<S>& J_bar) {
    return k.lift.transpose() *
           (F::velocity_force(k.printed, J_bar) - F::mass_block(k.printed, J_bar) * k.q_0);
  }
  static Unknown applied_force(const Kinematics& k, const Vector3<S>& n_bar) {
    return k.lift.transpose() * F::applied_force(k.printed, n_bar);
  }

  // internal row: satisfied by every x, so none remains
  static Matrix<S, 0, 3> internal_jacobian(const Kinematics&) { return {}; }
  static Vector<S, 0> internal_gamma(const Kinematics&) { return {}; }
  using Reduced = Kinematics;
  static constexpr bool reduced_mass_is_constant = false;
  static AngularMotion<S> angular_motion(const Reduced& k) {
    return {k.A, k.A, k.A * k.omega_bar, Vector3<S>::Zero()};
  }
  static Matrix3<S> reduced_mass_block(const Kinematics& k, const Matrix3<S>& J_bar) {
    return mass_block(k, J_bar);
  }
  static Vector3<S> reduced_force(const Kinematics& k, const Matrix3<S>& J_bar, const Vector3<S>& n_bar) {
    return applied_force(k, n_bar) + velocity_force(k, J_bar);
  }
  static Unknown from_reduced(const Kinematics&, const Vector3<S>& x) { return x; }
  static Unknown increment(const Kinematics&, const Vector3<S>& x) { return x; }
  static Vector3<S> omega_bar_dot_from_reduced(const Kinematics&, const Vector3<S>& x) { return x; }
  static Vector3<S> reduced(const Reduced&, const Unknown& force) { return force; }
  static Vector3<S> moment(const Reduced&, const Vector3<S>& n_bar) { return n_bar; }

  // the unknown is omega_bar'
  static Matrix3<S> lift(const Kinematics&) { return Matrix3<S>::Identity(); }
  static Vector3<S> to_angular_acceleration(const Kinematics&, const Unknown& x) { return x; }

  // orientation in an integrator: p, with the rate of r-omega
  static Orientation orientation_of(const Chart&, const Vector4<S>& p) { return p; }
  static Unknown velocity_of(const Chart& chart, const Coordinates& q) {
    const Vector3<S> none = Vector3<S>::Zero();
    return F::kinematics(chart, none, none, q).omega_bar;
  }
  static Coordinates from_orientation(const Chart& chart, const Orientation& p, const Unknown& omega_bar) {
    return F::from_pose(chart, p / p.norm(), omega_bar);
  }
  static Orientation orientation_rate(const Chart&, const Orientation& p, const Unknown& omega_bar) {
    return Turns::orientation_rate({}, p, omega_bar);
  }
  static Orientation retract(const Chart&, const Orientation& p, const Unknown& phi) {
    return Turns::retract({}, p, phi);
  }
  static void normalise(Orientation& p, Unknown& omega_bar) { Turns::normalise(p, omega_bar); }
  static Orientation step(const Chart&, const Orientation& p, const Unknown& phi) {
    return Turns::step({}, p, phi);
  }
  static Unknown displacement(const Chart&, const Orientation& from, const Orientation& to) {
    return Turns::displacement({}, from, to);
  }
  static Unknown displacement_rate(const Unknown& phi, const Unknown& omega_bar) {
    return Turns::displacement_rate(phi, omega_bar);
  }
  static void normalise_step(Orientation&, const S&, Unknown&) {}
  static void normalise_step_velocity(const Orientation&, const Unknown&, const S&, Unknown&) {}
  static constexpr bool inertia_is_constant = false;

  // conversion from and to a pose
  static S chart_distance(const Chart& chart, const Coordinates& q) { return F::chart_distance(chart, q); }
  static Chart choose_chart(const ChartOptions& options, const Vector4<S>& p) {
    return F::choose_chart(options, p);
  }
  static Coordinates from_pose(const Chart& chart, const Vector4<S>& p, const Vector3<S>& omega_bar) {
    return F::from_pose(chart, p, omega_bar);
  }
  static Vector4<S> to_euler_parameters(const Chart& chart, const Coordinates& q) {
    return F::to_euler_parameters(chart, q);
  }
};

namespace detail {
/// ReducedToRotation over another Scalar.
template <class F, class Scalar>
struct InScalar<ReducedToRotation<F>, Scalar> {
  using type = ReducedToRotation<InScalarT<F, Scalar>>;
};

/// WholeFormulation of an F with the printed equations alone.
template <class F>
struct WholeForm {
  // an incomplete part of F would be ignored silently: it is refused
  static_assert(
      ReducedEquations<F> || !requires { requires !std::is_void_v<typename F::Reduced>; },
      "the formulation has a type Reduced, but does not model the concept ReducedEquations");
  static_assert(
      MovingCoordinates<F> || !requires { requires !std::is_void_v<typename F::Orientation>; },
      "the formulation has a type Orientation, but does not model the concept MovingCoordinates");
  static_assert(ReducedEquations<F> == MovingCoordinates<F>,
                "a formulation has both a reduced and a moving part, or neither: both use the same unknowns");
  using type = ReducedToRotation<F>;
};
/// WholeFormulation of an F with all three parts.
template <Formulation F>
struct WholeForm<F> {
  using type = F;
};
}  // namespace detail

/// F itself if it has all three parts, otherwise ReducedToRotation of F. The structured solver and
/// simulations take this type.
template <EquationsAsPrinted F>
using WholeFormulation = typename detail::WholeForm<F>::type;

}  // namespace trivium
