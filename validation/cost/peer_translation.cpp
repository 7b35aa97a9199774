/// Builds the spanning tree of a scene, with relative coordinates that are 0 at its state, from the plain
/// data of the translation for Simbody.

#include "validation/cost/peer_translation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "bodies/rotations/so3.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/simbody/translation.hpp"

namespace trivium::cost {

namespace {

using V = trivium::Vector3<double>;
using M = trivium::Matrix3<double>;
using V4 = trivium::Vector4<double>;

Vector3 plain(const V& v) { return {v[0], v[1], v[2]}; }
V vector(const Vector3& v) { return {v[0], v[1], v[2]}; }

void raise_moments(simbody::Matrix3& inertia) {
  M J;
  for (std::size_t k = 0; k < 3; ++k) J.row(static_cast<int>(k)) = vector(inertia[k]);
  const Eigen::SelfAdjointEigenSolver<M> principal(J);
  const V moments = principal.eigenvalues();
  const double least = 1e-6 * moments[2];
  if (moments[0] >= least) return;
  J = principal.eigenvectors() * moments.cwiseMax(least).asDiagonal() * principal.eigenvectors().transpose();
  for (std::size_t k = 0; k < 3; ++k) inertia[k] = plain(J.row(static_cast<int>(k)));
}

/// Pose and velocity of a body, global frame. The ground rests at the origin.
struct Motion {
  V r = V::Zero(), r_dot = V::Zero(), omega = V::Zero();
  V4 p = V4::Unit(0);
  M A = M::Identity();
};

Motion motion_of(const simbody::Model& model, int body) {
  Motion motion;
  if (body == ground) return motion;
  const simbody::Body& b = model.bodies[static_cast<std::size_t>(body)];
  motion.r = vector(b.position);
  motion.p << b.euler_parameters[0], b.euler_parameters[1], b.euler_parameters[2], b.euler_parameters[3];
  motion.A = rotation_matrix(motion.p);
  motion.r_dot = vector(b.velocity);
  motion.omega = motion.A * vector(b.angular_velocity);
  return motion;
}

/// The spanning tree, breadth first from the ground, joints in file order. Simbody's translation builds the
/// same tree.
std::vector<TreeJoint> spanning_tree(const simbody::Model& model) {
  const std::size_t nb = model.bodies.size();
  std::vector<std::vector<int>> joints_of(nb + 1);  // the last entry is the ground's
  const auto node = [nb](int body) { return body == ground ? nb : static_cast<std::size_t>(body); };
  for (std::size_t k = 0; k < model.joints.size(); ++k)
    for (const int end : {model.joints[k].i, model.joints[k].j})
      joints_of[node(end)].push_back(static_cast<int>(k));
  std::vector<TreeJoint> tree;
  std::vector<bool> reached(nb + 1, false);
  reached[nb] = true;
  const auto hang = [&](int body, int parent, int joint, bool reversed) {
    TreeJoint branch;
    branch.body = body;
    branch.parent = parent;
    branch.joint = joint;
    branch.reversed = reversed;
    tree.push_back(branch);
    reached[node(body)] = true;
  };
  const auto hang_on = [&](int parent) {
    for (const int k : joints_of[node(parent)]) {
      const simbody::Joint& joint = model.joints[static_cast<std::size_t>(k)];
      if (joint.type == simbody::JointType::other) continue;
      if (joint.i == parent && !reached[node(joint.j)]) hang(joint.j, parent, k, false);
      if (joint.j == parent && !reached[node(joint.i)]) hang(joint.i, parent, k, true);
    }
  };
  hang_on(ground);
  std::size_t next = 0, free = 0;
  while (tree.size() < nb) {
    if (next < tree.size()) {
      hang_on(tree[next++].body);
      continue;
    }
    while (reached[free]) ++free;
    hang(static_cast<int>(free), ground, -1, false);
  }
  return tree;
}

/// The axes of a joint's free motions, in the child's frame.
std::vector<TreeJoint::Axis> free_axes(const simbody::Joint& joint, bool reversed, const M& A_parent,
                                       const M& A_child) {
  const simbody::JointFrame& on_parent = reversed ? joint.frame_j : joint.frame_i;
  const simbody::JointFrame& on_child = reversed ? joint.frame_i : joint.frame_j;
  const auto axis = [](bool slides, const V& direction) {
    TreeJoint::Axis a;
    a.slides = slides;
    a.direction = plain(direction.normalized());
    return a;
  };
  const V z = vector(on_child.z), u = vector(on_child.u), v = vector(on_child.v);
  switch (joint.type) {
    case simbody::JointType::revolute:
      return {axis(false, z)};
    case simbody::JointType::universal:
      return {axis(false, A_child.transpose() * A_parent * vector(on_parent.z)), axis(false, z)};
    case simbody::JointType::cylindrical:
      return {axis(true, z), axis(false, z)};
    case simbody::JointType::translational:
      return {axis(true, z)};
    case simbody::JointType::planar:
      return {axis(true, u), axis(true, v), axis(false, z)};
    case simbody::JointType::spherical:
    case simbody::JointType::fixed:
    case simbody::JointType::other:
      return {};
  }
  return {};
}

/// Sets the pose of the child relative to the parent, and the rates of the relative coordinates.
void place(TreeJoint& branch, const simbody::Model& model) {
  const Motion parent = motion_of(model, branch.parent), child = motion_of(model, branch.body);
  branch.position = plain(parent.A.transpose() * (child.r - parent.r));
  V4 conjugate = -parent.p;
  conjugate[0] = parent.p[0];
  V4 p = multiply_parameters<double>(conjugate, child.p);
  p /= p.norm();
  branch.orientation = {p[0], p[1], p[2], p[3]};
  const V omega = child.A.transpose() * (child.omega - parent.omega);
  branch.angular_velocity = plain(omega);
  branch.velocity = plain(child.r_dot);
  if (branch.joint < 0) {
    branch.kind = TreeJoint::Kind::free;
    return;
  }
  const simbody::Joint& joint = model.joints[static_cast<std::size_t>(branch.joint)];
  branch.point = branch.reversed ? joint.frame_i.point : joint.frame_j.point;
  if (joint.type == simbody::JointType::spherical) {
    branch.kind = TreeJoint::Kind::ball;
    return;
  }
  branch.axes = free_axes(joint, branch.reversed, parent.A, child.A);
  // velocity of the joint's point on the child, minus the velocity of the parent's point at the same place
  const V arm = child.A * vector(branch.point);
  const V velocity = child.A.transpose() * (child.r_dot + child.omega.cross(arm) - parent.r_dot -
                                            parent.omega.cross(child.r + arm - parent.r));
  Eigen::Matrix<double, 6, Eigen::Dynamic> directions(6, branch.axes.size());
  for (std::size_t k = 0; k < branch.axes.size(); ++k) {
    const V d = vector(branch.axes[k].direction), none = V::Zero();
    directions.col(static_cast<int>(k)) << (branch.axes[k].slides ? none : d),
        (branch.axes[k].slides ? d : none);
  }
  Eigen::Matrix<double, 6, 1> relative;
  relative << omega, velocity;
  if (branch.axes.empty()) return;
  const Eigen::VectorXd rates = directions.colPivHouseholderQr().solve(relative);
  for (std::size_t k = 0; k < branch.axes.size(); ++k) branch.axes[k].rate = rates[static_cast<int>(k)];
}

/// The loads of all effects except gravity; empty if all are zero.
std::vector<Load> loads_of(const scenes::Scene& scene) {
  const auto mechanism = make_mechanism<double>(scene);
  const auto state = make_state<double>(scene, 0.0);
  std::vector<BodyMotion<double>> motion(static_cast<std::size_t>(mechanism.nb()) + 1);
  for (int b = 0; b < mechanism.nb(); ++b)
    motion[b] = {state.pose[b].r, state.twist[b].r_dot, rotation_matrix(state.pose[b].p),
                 state.twist[b].omega_bar};
  std::vector<Wrench<double>> wrenches(motion.size()), weights(motion.size());
  const double t = 0;
  const EffectView<double> view{mechanism.bodies, motion, t};
  mechanism.effects.apply(view, wrenches);
  for (const auto& gravity : mechanism.effects.all<Gravity<double>>()) gravity.apply(view, weights);
  std::vector<Load> loads;
  bool any = false;
  for (int b = 0; b < mechanism.nb(); ++b) {
    const V force = wrenches[b].F - weights[b].F, moment = wrenches[b].n_bar - weights[b].n_bar;
    any = any || force != V::Zero() || moment != V::Zero();
    loads.push_back({plain(force), plain(motion[b].A * moment)});
  }
  return any ? loads : std::vector<Load>{};
}

bool all_turn_about_one_direction(const simbody::Model& model) {
  std::vector<V> axes;
  for (const simbody::Joint& joint : model.joints) {
    if (joint.type != simbody::JointType::revolute) return false;
    axes.push_back(motion_of(model, joint.i).A * vector(joint.frame_i.z));
  }
  // parallel up to rounding: 1e-12 is about 1e4 u
  return std::all_of(axes.begin(), axes.end(),
                     [&](const V& axis) { return axis.cross(axes.front()).norm() < 1e-12; });
}

}  // namespace

PeerScene to_peers(const scenes::Scene& scene) {
  PeerScene peers;
  peers.model = to_simbody(scene, 0);
  for (simbody::Body& body : peers.model.bodies) raise_moments(body.inertia);
  for (const simbody::Vector3& g : peers.model.gravity)
    peers.gravity = plain(vector(peers.gravity) + vector(g));
  peers.loads = loads_of(scene);
  peers.tree = spanning_tree(peers.model);
  std::vector<bool> in_tree(peers.model.joints.size(), false);
  for (TreeJoint& branch : peers.tree) {
    place(branch, peers.model);
    if (branch.joint >= 0) in_tree[static_cast<std::size_t>(branch.joint)] = true;
  }
  for (std::size_t k = 0; k < in_tree.size(); ++k)
    if (!in_tree[k]) peers.closings.push_back(static_cast<int>(k));
  peers.is_planar = all_turn_about_one_direction(peers.model);
  return peers;
}

}  // namespace trivium::cost
