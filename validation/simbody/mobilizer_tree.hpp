#pragma once
/// The spanning tree of a model's joint graph and its mobilizers. Decides which joints become mobilizers, and
/// which closing rows the tree satisfies identically. Internal to the Simbody library.

#include "validation/simbody/rows.hpp"

namespace trivium::simbody {

/// How a body hangs in the tree: by a joint on the body `parent`, or free on Ground where `joint` is none.
struct Branch {
  static constexpr int none = -1;
  int body = 0, parent = ground, joint = none;
  bool reversed = false;  ///< the parent is the joint's body j
};

/// Breadth first from the ground, so that parents come before children. Joints are taken in file order where
/// Simbody has a mobilizer for them; a body that none of them reaches is free. With `use_joints` false all
/// bodies are.
std::vector<Branch> spanning_tree(const Model& model, bool use_joints);

/// Adds the branch's body to the matter, M and F such that the model's state lies at regular coordinates.
SimTK::MobilizedBodyIndex add_mobilizer(const Model& model, const Branch& branch, const BodyMap& bodies);

/// The pose of a body in Ground, and its velocity there, as the model states them.
SimTK::Transform pose_of(const Model& model, int body);
SimTK::SpatialVec velocity_of(const Model& model, int body);

/// Whether the row's forces on the bodies do no work along any mobility at the state (realised to
/// Stage::Velocity).
bool is_idle(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::Constraint& row,
             const SimTK::State& state);

/// Sets the mobilizer's coordinates and speeds to the model's state.
void fit_mobilizer(const Model& model, const Branch& branch, const BodyMap& bodies, SimTK::State& state);

}  // namespace trivium::simbody
