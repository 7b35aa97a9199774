/// Computes Phi, its first and second time derivative and the forces of a multiplier from the motions of two
/// bodies. Every row is the scalar product of two moving vectors, minus f(t).

#include "validation/simbody/custom_constraint.hpp"

#include <cmath>

namespace trivium::simbody {

using SimTK::SpatialVec;
using SimTK::Vec3;

/// Ground is added first, so that it is the ancestor body and all motions are given in its frame.
CustomRow::CustomRow(const Row& row, const BodyMap& bodies)
    : Implementation(bodies.matter, 1, 0, 0), row_(row) {
  const SimTK::ConstrainedBodyIndex on_ground = addConstrainedBody(bodies[ground]);
  i_ = row.i == ground ? on_ground : addConstrainedBody(bodies[row.i]);
  j_ = row.j == ground ? on_ground : addConstrainedBody(bodies[row.j]);
}

/// A vector with components `in_body` that may vary with time, with its derivatives in Ground (% is the cross
/// product).
CustomRow::Moving CustomRow::follow(const BodyMotion& body, const Moving& in_body) {
  const SimTK::Rotation& R = body.X.R();
  const Vec3 &w = body.V[0], &b = body.A[0];
  const Vec3 a = R * in_body.value, a_t = R * in_body.rate, a_tt = R * in_body.acceleration;
  return {a, w % a + a_t, b % a + w % (w % a) + 2 * (w % a_t) + a_tt};
}

/// The offset d_ij = (r_j + A_j s_j) - (r_i + A_i s_i).
CustomRow::Moving CustomRow::offset(const BodyMotion& i, const BodyMotion& j) const {
  const Moving s_i = follow(i, {vec(row_.s_i)}), s_j = follow(j, {vec(row_.s_j)});
  return {(j.X.p() + s_j.value) - (i.X.p() + s_i.value), (j.V[1] + s_j.rate) - (i.V[1] + s_i.rate),
          (j.A[1] + s_j.acceleration) - (i.A[1] + s_i.acceleration)};
}

CustomRow::Factors CustomRow::factors(const BodyMotion& i, const BodyMotion& j, double t) const {
  const Vector3 f = row_.f.value(t);
  switch (row_.type) {
    case RowType::dp1:
      return {follow(i, {vec(row_.a_i)}), follow(j, {vec(row_.a_j)}), f};
    case RowType::turning_dp1: {  // f is alpha; w = -sin(alpha) u + cos(alpha) v, dw/dalpha = -x
      const double s = std::sin(f[0]), c = std::cos(f[0]);
      const Vec3 w = -s * vec(row_.a_i) + c * vec(row_.v_i), x = c * vec(row_.a_i) + s * vec(row_.v_i);
      const Moving turning{w, -f[1] * x, -f[2] * x - f[1] * f[1] * w};
      return {follow(i, turning), follow(j, {vec(row_.a_j)}), Vector3{}};
    }
    case RowType::dp2:
      return {follow(i, {vec(row_.a_i)}), offset(i, j), f};
    case RowType::d:
      return {offset(i, j), offset(i, j), f};
    case RowType::cd:
      return {{vec(row_.a_i)}, offset(i, j), f};
  }
  return {};
}

CustomRow::BodyMotion CustomRow::from_state(const SimTK::State& state,
                                            SimTK::ConstrainedBodyIndex body) const {
  return {getBodyTransformFromState(state, body)};
}

void CustomRow::calcPositionErrors(const SimTK::State& state,
                                   const SimTK::Array_<SimTK::Transform, SimTK::ConstrainedBodyIndex>& X,
                                   const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                                   SimTK::Array_<SimTK::Real>& error) const {
  const auto [x, y, f] = factors({getBodyTransform(X, i_)}, {getBodyTransform(X, j_)}, state.getTime());
  error[0] = SimTK::dot(x.value, y.value) - f[0];
}

void CustomRow::calcPositionDotErrors(const SimTK::State& state,
                                      const SimTK::Array_<SpatialVec, SimTK::ConstrainedBodyIndex>& V,
                                      const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                                      SimTK::Array_<SimTK::Real>& error) const {
  BodyMotion i = from_state(state, i_), j = from_state(state, j_);
  i.V = getBodyVelocity(V, i_);
  j.V = getBodyVelocity(V, j_);
  const auto [x, y, f] = factors(i, j, state.getTime());
  error[0] = SimTK::dot(x.rate, y.value) + SimTK::dot(x.value, y.rate) - f[1];
}

void CustomRow::calcPositionDotDotErrors(const SimTK::State& state,
                                         const SimTK::Array_<SpatialVec, SimTK::ConstrainedBodyIndex>& A,
                                         const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                                         SimTK::Array_<SimTK::Real>& error) const {
  BodyMotion i = from_state(state, i_), j = from_state(state, j_);
  i.V = getBodyVelocityFromState(state, i_);
  j.V = getBodyVelocityFromState(state, j_);
  i.A = getBodyAcceleration(A, i_);
  j.A = getBodyAcceleration(A, j_);
  const auto [x, y, f] = factors(i, j, state.getTime());
  error[0] = SimTK::dot(x.acceleration, y.value) + SimTK::dot(x.value, y.acceleration) +
             2 * SimTK::dot(x.rate, y.rate) - f[2];
}

/// Applies G^T lambda. Let w = lambda y. If x is a body vector, delta x . w = delta theta . (x % w), a
/// torque. If x is an offset, w acts at its point on j and -w at its point on i. The same holds with x and y
/// exchanged.
void CustomRow::addInPositionConstraintForces(
    const SimTK::State& state, const SimTK::Array_<SimTK::Real>& multipliers,
    SimTK::Array_<SpatialVec, SimTK::ConstrainedBodyIndex>& body_forces,
    SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&) const {
  const auto [x, y, f] = factors(from_state(state, i_), from_state(state, j_), state.getTime());
  const double lambda = multipliers[0];
  const auto push_apart = [&](const Vec3& force) {
    addInStationForce(state, j_, vec(row_.s_j), force, body_forces);
    addInStationForce(state, i_, vec(row_.s_i), -force, body_forces);
  };
  switch (row_.type) {
    case RowType::dp1:
    case RowType::turning_dp1:
      addInBodyTorque(state, i_, lambda * (x.value % y.value), body_forces);
      addInBodyTorque(state, j_, lambda * (y.value % x.value), body_forces);
      break;
    case RowType::dp2:
      addInBodyTorque(state, i_, lambda * (x.value % y.value), body_forces);
      push_apart(lambda * x.value);
      break;
    case RowType::d:
      push_apart(2 * lambda * x.value);
      break;
    case RowType::cd:
      push_apart(lambda * x.value);
      break;
  }
}

LinkedConstraint custom_row(const Model& model, int joint, int row, const BodyMap& bodies) {
  const SimTK::Constraint::Custom custom(new CustomRow(model.rows[static_cast<std::size_t>(row)], bodies));
  return {custom.getConstraintIndex(), joint, {{row, 1.0}}};
}

void add_custom_rows(const Model& model, int joint, const BodyMap& bodies,
                     std::vector<LinkedConstraint>& out) {
  const Joint& owner = model.joints[static_cast<std::size_t>(joint)];
  for (int row = owner.first_row; row < owner.first_row + owner.rows; ++row)
    out.push_back(custom_row(model, joint, row, bodies));
}

}  // namespace trivium::simbody
