#pragma once
/// The contract of a formulation: one set of absolute coordinates (r, orientation) per body and the equations
/// of motion written in it. Four files stand side by side, same headings, same order: r_omega, r_p, r_epsilon
/// and r_epsilon_omega_first. Each is native: its Jacobians, biases, mass block and forces come from its own
/// coordinates, never from another formulation's numbers; that lambda agrees is the theorem, not the
/// implementation.
///
/// Per body, with n = rotational_unknowns and m = internal_constraints (0 except for r-p's normalisation
/// row):
///
///   m r''          + Phi_r^T lambda                        = F
///   mass_block q'' + Phi_rot^T lambda + P^T lambda_internal = applied_force(n_bar) + velocity_force
///   Phi_r r'' + Phi_rot q''                                = gamma
///   P q''                                                  = internal_gamma

#include <concepts>
#include <string_view>

#include "constraints/feature.hpp"
#include "formulations/contract/angular_motion.hpp"

namespace trivium {

/// What the caller may say about charts; only a formulation that has charts listens.
struct ChartOptions {
  EulerSequence sequence;  ///< default 3-1-3
  bool reframe = true;  ///< turn a body's reference frame where the sequence would stand near its singularity
};

/// Nothing to choose and nothing to store: the chart of a formulation without charts.
struct NoChart {
  std::string_view name() const { return {}; }
};

/// How the literature writes a formulation's blocks; empty where it has no such block.
struct BlockNames {
  std::string_view unknown, mass, jacobian, force, internal_jacobian, internal_multiplier;
};

template <class F>
concept Formulation = BodyKinematics<typename F::Kinematics> &&
    requires(const typename F::Scalar& s, const typename F::Chart& chart, const ChartOptions& options,
             const Vector4<typename F::Scalar>& p, const Vector3<typename F::Scalar>& v,
             const Matrix3<typename F::Scalar>& J_bar, const typename F::Coordinates& q,
             const typename F::Kinematics& body, const typename F::Reduced& reduced,
             const Vector<typename F::Scalar, F::rotational_unknowns>& x, const typename F::Orientation& flat,
             typename F::Orientation& moved, typename F::Unknown& moved_x) {
  // constants
  { F::name } -> std::convertible_to<std::string_view>;
  { F::rotational_unknowns } -> std::convertible_to<int>;
  { F::internal_constraints } -> std::convertible_to<int>;
  { F::block_names } -> std::convertible_to<BlockNames>;
  // conversion from a pose (p, omega_bar), in a chart that is chosen first, and back
  { F::choose_chart(options, p) } -> std::same_as<typename F::Chart>;
  // how far q is from where its chart has no rates: 1 at most, 0 there
  { F::chart_distance(chart, q) } -> std::convertible_to<typename F::Scalar>;
  { F::from_pose(chart, p, v) } -> std::same_as<typename F::Coordinates>;
  { F::to_euler_parameters(chart, q) } -> std::convertible_to<Vector4<typename F::Scalar>>;
  // orientation, and with it a body vector's value, Jacobian, rate and bias (BodyKinematics)
  { F::kinematics(chart, v, v, q) } -> std::same_as<typename F::Kinematics>;
  // mass block, quadratic-velocity force, applied force of a body-frame moment
  {F::mass_block(body, J_bar)};
  {F::velocity_force(body, J_bar)};
  {F::applied_force(body, v)};
  // internal row
  {F::internal_jacobian(body)};
  {F::internal_gamma(body)};
  // internal row eliminated in closed form: three rotational unknowns x, q'' = from_reduced(x), and with them
  //   reduced_mass_block x + Phi_x^T lambda = reduced_force(n_bar)
  requires BodyKinematics<typename F::Reduced>;
  { F::turning(reduced) } -> std::same_as<AngularMotion<typename F::Scalar>>;
  requires F::Reduced::rotational_unknowns == 3;
  { F::reduced_mass_is_constant } -> std::convertible_to<bool>;
  { F::reduced_mass_block(body, J_bar) } -> std::convertible_to<Matrix3<typename F::Scalar>>;
  { F::reduced_force(body, J_bar, v) } -> std::convertible_to<Vector3<typename F::Scalar>>;
  { F::from_reduced(body, v) } -> std::convertible_to<typename F::Unknown>;
  // how far the unknown moves with x
  { F::increment(body, v) } -> std::convertible_to<typename F::Unknown>;
  // the rotational unknown and omega_bar': q'' = lift omega_bar' + (terms of q, q'), and back
  {F::lift(body)};
  { F::to_angular_acceleration(body, x) } -> std::convertible_to<Vector3<typename F::Scalar>>;
  {F::from_angular_acceleration(body, v)};
  // retraction: q moved by an increment of the rotational unknown's kind, rates kept
  { F::retract_coordinates(chart, q, x) } -> std::same_as<typename F::Coordinates>;
  // flat form, as libraries for ordinary differential equations carry it: the orientation, and a velocity of
  // which the unknown is the derivative; with the orientation's rate, its retraction, and what meets the
  // internal row and its derivative
  { F::orientation_size } -> std::convertible_to<int>;
  { F::orientation_of(chart, p) } -> std::convertible_to<typename F::Orientation>;
  { F::velocity_of(chart, q) } -> std::convertible_to<typename F::Unknown>;
  { F::from_orientation(chart, flat, x) } -> std::same_as<typename F::Coordinates>;
  { F::orientation_rate(chart, flat, x) } -> std::convertible_to<typename F::Orientation>;
  { F::retract(chart, flat, x) } -> std::convertible_to<typename F::Orientation>;
  F::normalise(moved, moved_x);
  // steps of implicit methods, in the same numbers: where a displacement leads, off the internal row too, and
  // from where to where it is; how it grows where the body moves with a velocity; the way back onto the
  // internal row and its derivative (by a share of what is added to the unknown); whether M depends on q
  { F::step(chart, flat, x) } -> std::convertible_to<typename F::Orientation>;
  { F::displacement(chart, flat, flat) } -> std::convertible_to<typename F::Unknown>;
  { F::displacement_rate(x, x) } -> std::convertible_to<typename F::Unknown>;
  F::normalise_step(moved, s, moved_x);
  F::normalise_step_velocity(flat, x, s, moved_x);
  { F::inertia_is_constant } -> std::convertible_to<bool>;
  // a generalised force without what it does to the internal row, and that as a moment in the body frame
  { F::reduced(reduced, x) } -> std::convertible_to<Vector3<typename F::Scalar>>;
  { F::moment(reduced, v) } -> std::convertible_to<Vector3<typename F::Scalar>>;
};

}  // namespace trivium
