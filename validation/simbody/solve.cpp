/// Reads accelerations, multipliers and reactions from a realised Simbody state. An exception of Simbody, or
/// an answer that is not finite, becomes Refused.

#include "validation/simbody/solve.hpp"

#include <algorithm>
#include <cmath>

#include "base/raise.hpp"
#include "validation/simbody/system.hpp"

namespace trivium::simbody {

namespace {

using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;

Vec3 point_on_i(const System& system, const Joint& joint) {
  return system.bodies[joint.i].findStationLocationInGround(system.state, vec(joint.frame_i.point));
}

/// The largest difference between G^T, which Simbody forms from the forces of its constraints, and G, from
/// their errors.
double jacobian_defect(const System& system) {
  if (system.constraints.empty()) return 0;
  SimTK::Matrix G, G_transposed;
  system.matter.calcG(system.state, G);
  system.matter.calcGTranspose(system.state, G_transposed);
  double defect = 0;
  for (int row = 0; row < G.nrow(); ++row)
    for (int u = 0; u < G.ncol(); ++u) raise(defect, std::abs(G(row, u) - G_transposed(u, row)));
  return defect;
}

void read_bodies(const System& system, Answer& out) {
  for (int b = 0; b < static_cast<int>(system.model.bodies.size()); ++b) {
    const MobilizedBody& body = system.bodies[b];
    const SpatialVec& A = body.getBodyAcceleration(system.state);
    out.r_ddot.push_back(array(A[1]));
    out.omega_bar_dot.push_back(array(~body.getBodyRotation(system.state) * A[0]));
    const Transform X = pose_of(system.model, b);
    const SpatialVec V = velocity_of(system.model, b), dV = body.getBodyVelocity(system.state) - V;
    const Rotation dR = ~X.R() * body.getBodyRotation(system.state);
    for (const double off : {(body.getBodyOriginLocation(system.state) - X.p()).norm(),
                             std::abs(dR.convertRotationToAngleAxis()[0]), dV[0].norm(), dV[1].norm()})
      raise(out.pose_defect, off);
  }
}

void read_multipliers(const System& system, Answer& out) {
  out.lambda.assign(system.model.rows.size(), 0.0);
  out.lambda_known.assign(system.model.rows.size(), false);
  for (const int row : system.idle_rows) out.lambda_known[static_cast<std::size_t>(row)] = true;
  for (const LinkedConstraint& c : system.constraints) {
    const SimTK::Vector multipliers =
        system.matter.getConstraint(c.index).getMultipliersAsVector(system.state);
    for (std::size_t k = 0; k < c.rows.size(); ++k) {
      const std::size_t row = static_cast<std::size_t>(c.rows[k].row);
      out.lambda[row] = c.rows[k].scale * multipliers[static_cast<int>(k)];
      out.lambda_known[row] = true;
    }
  }
}

/// The reaction on body j about the joint's point on i, from Simbody's reaction on the child at M.
SpatialVec mobilizer_reaction(const System& system, const Joint& joint, const Branch& branch,
                              const SimTK::Vector_<SpatialVec>& on_child) {
  const MobilizedBody& child = system.bodies[branch.body];
  const SpatialVec& at_M = on_child[child.getMobilizedBodyIndex()];
  const Vec3 M = child.findStationLocationInGround(system.state, child.getOutboardFrame(system.state).p());
  const SpatialVec moved(at_M[0] + (M - point_on_i(system, joint)) % at_M[1], at_M[1]);
  return branch.reversed ? SpatialVec(-moved[0], -moved[1]) : moved;
}

/// The reaction -G^T lambda on a body of the joint. Simbody gives it at the body's origin; the result is
/// about the joint's point on i.
SpatialVec constraint_reaction(const System& system, const Joint& joint, int body,
                               const SimTK::Constraint& constraint) {
  SimTK::Vector_<SpatialVec> applied;
  SimTK::Vector mobility_forces;
  constraint.calcConstraintForcesFromMultipliers(
      system.state, constraint.getMultipliersAsVector(system.state), applied, mobility_forces);
  const MobilizedBody& end = system.bodies[body];
  const Vec3 arm = end.getBodyOriginLocation(system.state) - point_on_i(system, joint);
  SpatialVec sum(Vec3(0), Vec3(0));
  for (SimTK::ConstrainedBodyIndex b(0); b < constraint.getNumConstrainedBodies(); ++b)
    if (constraint.getMobilizedBodyFromConstrainedBody(b).getMobilizedBodyIndex() ==
        end.getMobilizedBodyIndex())
      sum -= SpatialVec(applied[b][0] + arm % applied[b][1], applied[b][1]);
  return sum;
}

void read_reactions(const System& system, Answer& out) {
  std::vector<SpatialVec> on_i(system.model.joints.size(), SpatialVec(Vec3(0), Vec3(0))), on_j = on_i;
  SimTK::Vector_<SpatialVec> on_child;
  system.matter.calcMobilizerReactionForces(system.state, on_child);
  for (std::size_t k = 0; k < on_j.size(); ++k) {
    if (!system.branch_of_joint[k]) continue;
    on_j[k] = mobilizer_reaction(system, system.model.joints[k], *system.branch_of_joint[k], on_child);
    on_i[k] = SpatialVec(-on_j[k][0], -on_j[k][1]);
  }
  for (const LinkedConstraint& c : system.constraints) {
    const std::size_t k = static_cast<std::size_t>(c.joint);
    const SimTK::Constraint& constraint = system.matter.getConstraint(c.index);
    on_i[k] += constraint_reaction(system, system.model.joints[k], system.model.joints[k].i, constraint);
    on_j[k] += constraint_reaction(system, system.model.joints[k], system.model.joints[k].j, constraint);
  }
  for (std::size_t k = 0; k < on_j.size(); ++k) {
    const Vector3 point = array(point_on_i(system, system.model.joints[k]));
    out.reactions_on_i.push_back({array(on_i[k][1]), array(on_i[k][0]), point});
    out.reactions_on_j.push_back({array(on_j[k][1]), array(on_j[k][0]), point});
  }
}

Answer answer_of(const System& system) {
  Answer out;
  read_bodies(system, out);
  read_multipliers(system, out);
  read_reactions(system, out);
  out.jacobian_defect = jacobian_defect(system);
  for (const Branch* branch : system.branch_of_joint) out.mobilizers += branch ? 1 : 0;
  for (const LinkedConstraint& c : system.constraints) out.constraint_rows += static_cast<int>(c.rows.size());
  out.idle_rows = static_cast<int>(system.idle_rows.size());
  return out;
}

bool is_finite(const Vector3& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

bool is_finite(const Answer& answer) {
  const auto finite = [](const auto& v) { return is_finite(v); };
  const auto finite_reaction = [](const Reaction& r) { return is_finite(r.force) && is_finite(r.torque); };
  return std::all_of(answer.r_ddot.begin(), answer.r_ddot.end(), finite) &&
         std::all_of(answer.omega_bar_dot.begin(), answer.omega_bar_dot.end(), finite) &&
         std::all_of(answer.lambda.begin(), answer.lambda.end(), [](double x) { return std::isfinite(x); }) &&
         std::all_of(answer.reactions_on_i.begin(), answer.reactions_on_i.end(), finite_reaction) &&
         std::all_of(answer.reactions_on_j.begin(), answer.reactions_on_j.end(), finite_reaction);
}

}  // namespace

Answer solve(const Model& model, Way way) {
  Answer answer;
  try {
    answer = answer_of(System(model, way));
  } catch (const Refused&) {
    throw;
  } catch (const std::exception& error) {
    throw Refused(on_one_line(error.what()));
  }
  if (!is_finite(answer)) throw Refused("Simbody's accelerations or multipliers are not finite");
  return answer;
}

}  // namespace trivium::simbody
