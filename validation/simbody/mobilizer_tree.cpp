/// Chooses Simbody's mobilizer for every joint of the tree, and its frames on both bodies.

#include "validation/simbody/mobilizer_tree.hpp"

#include "validation/simbody/way.hpp"

namespace trivium::simbody {

namespace {

using SimTK::Inertia;
using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;

const Joint& joint_of(const Model& model, const Branch& branch) {
  return model.joints[static_cast<std::size_t>(branch.joint)];
}

SimTK::Body::Rigid rigid_body(const Body& body) {
  const Matrix3& J = body.inertia;
  const Inertia inertia(J[0][0], J[1][1], J[2][2], J[0][1], J[0][2], J[1][2]);
  return SimTK::Body::Rigid(SimTK::MassProperties(body.mass, Vec3(0), inertia));
}

Rotation columns(const Vec3& x, const Vec3& y, const Vec3& z) {
  return Rotation(SimTK::Mat33(x, y, z), true);
}

/// The mobilizer frame of a joint on one body. The joint's axis z becomes the axis of Simbody's mobilizer: z
/// of a pin, a cylinder or a planar mobilizer, x of a slider.
Transform frame_on_body(JointType type, const JointFrame& f) {
  const Vec3 u = vec(f.u), v = vec(f.v), z = vec(f.z), point = vec(f.point);
  if (type == JointType::spherical) return Transform(point);
  if (type == JointType::translational) return {columns(z, u, v), point};
  return {columns(u, v, z), point};
}

/// Simbody's universal joint rotates about x of F, then about y of M. The other axes of both frames are
/// chosen so that both angles are zero at the model's state, far from the singularity of the joint.
std::pair<Transform, Transform> universal_frames(const Rotation& R_parent_child, const JointFrame& on_parent,
                                                 const JointFrame& on_child) {
  const auto made_normal_to = [](const Vec3& v, const Vec3& axis) {
    return Vec3(UnitVec3(v - SimTK::dot(v, axis) * axis));
  };
  const Vec3 x_parent = vec(on_parent.z), y_child = vec(on_child.z);
  const Vec3 y_parent = made_normal_to(R_parent_child * y_child, x_parent);
  const Vec3 x_child = made_normal_to(~R_parent_child * x_parent, y_child);
  return {Transform(columns(x_parent, y_parent, x_parent % y_parent), vec(on_parent.point)),
          Transform(columns(x_child, y_child, x_child % y_child), vec(on_child.point))};
}

/// The mobilizer frames: F on the parent and M on the child.
std::pair<Transform, Transform> mobilizer_frames(const Model& model, const Branch& branch) {
  if (branch.joint == Branch::none) return {};
  const Joint& joint = joint_of(model, branch);
  const JointFrame& on_parent = branch.reversed ? joint.frame_j : joint.frame_i;
  const JointFrame& on_child = branch.reversed ? joint.frame_i : joint.frame_j;
  if (joint.type == JointType::universal)
    return universal_frames(~pose_of(model, branch.parent).R() * pose_of(model, branch.body).R(), on_parent,
                            on_child);
  return {frame_on_body(joint.type, on_parent), frame_on_body(joint.type, on_child)};
}

template <class Mobilizer>
SimTK::MobilizedBodyIndex add(MobilizedBody& parent, const std::pair<Transform, Transform>& frames,
                              const Body& body) {
  return Mobilizer(parent, frames.first, rigid_body(body), frames.second).getMobilizedBodyIndex();
}

}  // namespace

std::vector<Branch> spanning_tree(const Model& model, bool use_joints) {
  const std::size_t nb = model.bodies.size();
  std::vector<Branch> tree;
  std::vector<bool> reached(nb, false);
  const auto is_in_tree = [&](int body) { return body == ground || reached[static_cast<std::size_t>(body)]; };
  const auto hang = [&](const Branch& branch) {
    tree.push_back(branch);
    reached[static_cast<std::size_t>(branch.body)] = true;
  };
  const auto hang_on = [&](int parent) {
    for (std::size_t k = 0; k < model.joints.size(); ++k) {
      const Joint& joint = model.joints[k];
      if (joint.type == JointType::other) continue;
      if (joint.i == parent && !is_in_tree(joint.j)) hang({joint.j, parent, static_cast<int>(k), false});
      if (joint.j == parent && !is_in_tree(joint.i)) hang({joint.i, parent, static_cast<int>(k), true});
    }
  };
  if (use_joints) hang_on(ground);
  std::size_t next = 0, free = 0;
  while (tree.size() < nb) {
    if (use_joints && next < tree.size()) {
      hang_on(tree[next++].body);
      continue;
    }
    while (reached[free]) ++free;
    hang({static_cast<int>(free)});
  }
  return tree;
}

SimTK::MobilizedBodyIndex add_mobilizer(const Model& model, const Branch& branch, const BodyMap& bodies) {
  const auto frames = mobilizer_frames(model, branch);
  const Body& body = model.bodies[static_cast<std::size_t>(branch.body)];
  MobilizedBody& parent = bodies[branch.parent];
  if (branch.joint == Branch::none) return add<MobilizedBody::Free>(parent, frames, body);
  switch (joint_of(model, branch).type) {
    case JointType::revolute:
      return add<MobilizedBody::Pin>(parent, frames, body);
    case JointType::universal:
      return add<MobilizedBody::Universal>(parent, frames, body);
    case JointType::spherical:
      return add<MobilizedBody::Ball>(parent, frames, body);
    case JointType::cylindrical:
      return add<MobilizedBody::Cylinder>(parent, frames, body);
    case JointType::translational:
      return add<MobilizedBody::Slider>(parent, frames, body);
    case JointType::planar:
      return add<MobilizedBody::Planar>(parent, frames, body);
    case JointType::fixed:
      return add<MobilizedBody::Weld>(parent, frames, body);
    case JointType::other:
      break;
  }
  throw Refused("no mobilizer for this joint");
}

Transform pose_of(const Model& model, int body) {
  if (body == ground) return {};
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  const auto& e = b.euler_parameters;
  return {Rotation(SimTK::Quaternion(SimTK::Vec4(e[0], e[1], e[2], e[3]))), vec(b.position)};
}

SpatialVec velocity_of(const Model& model, int body) {
  if (body == ground) return {Vec3(0), Vec3(0)};
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  return {pose_of(model, body).R() * vec(b.angular_velocity), vec(b.velocity)};
}

bool is_idle(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::Constraint& row,
             const SimTK::State& state) {
  const SimTK::Vector one(1, 1.0);
  SimTK::Vector lambda, mobility_forces, along_mobilities;
  SimTK::Vector_<SimTK::SpatialVec> body_forces;
  row.calcConstraintForcesFromMultipliers(state, one, body_forces, mobility_forces);
  row.setMyPartInConstraintSpaceVector(state, one, lambda);
  matter.multiplyByGTranspose(state, lambda, along_mobilities);
  double size = 0;
  for (int b = 0; b < body_forces.size(); ++b) size += body_forces[b].norm();
  return along_mobilities.norm() <= 1e-10 * size;
}

void fit_mobilizer(const Model& model, const Branch& branch, const BodyMap& bodies, SimTK::State& state) {
  const MobilizedBody& child = bodies[branch.body];
  const Transform X_P = pose_of(model, branch.parent), X_B = pose_of(model, branch.body);
  const SpatialVec V_P = velocity_of(model, branch.parent), V_B = velocity_of(model, branch.body);
  const Transform X_F = X_P * child.getDefaultInboardFrame(), X_M = X_B * child.getDefaultOutboardFrame();
  child.setQToFitTransform(state, ~X_F * X_M);
  // velocity of M's origin, minus the velocity of the parent's point at the same place (% is the cross
  // product)
  const Vec3 w = V_B[0] - V_P[0];
  const Vec3 v = V_B[1] + V_B[0] % (X_M.p() - X_B.p()) - (V_P[1] + V_P[0] % (X_M.p() - X_P.p()));
  child.setUToFitVelocity(state, {~X_F.R() * w, ~X_F.R() * v});
}

}  // namespace trivium::simbody
