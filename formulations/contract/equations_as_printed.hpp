#pragma once
/// The first part of a formulation: the equations of motion of one body as the textbooks print them. The
/// augmented system needs nothing else.
///
///     mass r''       + Phi_r^T lambda                        = force
///     mass_block q'' + Phi_rot^T lambda + P^T lambda_internal = applied_force(n_bar) + velocity_force
///     Phi_r r'' + Phi_rot q''                                = gamma
///     P q''                                                  = internal_gamma
///
/// q'' has n = rotational_unknowns components. P has m = internal_constraints rows, the internal rows of the
/// body: constraints between the coordinates of one body. m is 1 in r-p, where the internal row normalises p,
/// and 0 in the other formulations of the library. The force is in N, global, the moment n_bar in N m, body
/// frame. Unknown is the vector q''. Coordinates are the rotational coordinates of a body and their first
/// derivatives, without r.

#include <concepts>
#include <string_view>

#include "bodies/rigid_body.hpp"
#include "constraints/body_kinematics.hpp"
#include "formulations/contract/chart_options.hpp"

namespace trivium {

/// What a formulation F must have to be solved as printed.
template <class F>
concept EquationsAsPrinted = BodyKinematics<typename F::Kinematics> &&
    std::derived_from<typename F::Kinematics, BodyMotion<typename F::Scalar>> &&
    requires(const typename F::Chart& chart, const ChartOptions& options,
             const Vector4<typename F::Scalar>& p, const Vector3<typename F::Scalar>& v,
             const Matrix3<typename F::Scalar>& J_bar, const typename F::Coordinates& q,
             const typename F::Kinematics& body, const typename F::Unknown& q_ddot) {
  // constants
  { F::name } -> std::convertible_to<std::string_view>;
  { F::rotational_unknowns } -> std::convertible_to<int>;
  { F::internal_constraints } -> std::convertible_to<int>;
  // conversion between (p, omega_bar) and coordinates, in a chart that is chosen first
  { F::choose_chart(options, p) } -> std::same_as<typename F::Chart>;
  { chart.name() } -> std::convertible_to<std::string_view>;  // empty for formulations without charts
  // distance of q from the singularity of its chart: at most 1, and 0 where the rates are not defined. Below
  // 0.3 a simulation calls choose_chart again. choose_chart throws a ModelError if no chart of the
  // formulation suits the orientation
  { F::chart_distance(chart, q) } -> std::convertible_to<typename F::Scalar>;
  { F::from_pose(chart, p, v) } -> std::same_as<typename F::Coordinates>;
  { F::to_euler_parameters(chart, q) } -> std::convertible_to<Vector4<typename F::Scalar>>;
  // orientation, and the value, Jacobian, rate and bias of body vectors (BodyKinematics), from (chart, r, r',
  // q): r [m] and r' [m/s] in the global frame
  { F::kinematics(chart, v, v, q) } -> std::same_as<typename F::Kinematics>;
  // mass block [n x n], quadratic-velocity force [n], generalized force [n] of a moment in the body frame
  {F::mass_block(body, J_bar)};
  {F::velocity_force(body, J_bar)};
  {F::applied_force(body, v)};
  // internal rows: P [m x n] and the right side [m]
  {F::internal_jacobian(body)};
  {F::internal_gamma(body)};
  // rotational unknown and omega_bar': q'' = lift omega_bar' + (terms of q and q'), lift [n x 3], and
  // omega_bar' from q''
  {F::lift(body)};
  { F::to_angular_acceleration(body, q_ddot) } -> std::convertible_to<Vector3<typename F::Scalar>>;
};

}  // namespace trivium
