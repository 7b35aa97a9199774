#pragma once
/// The spanning tree of a model's joint graph, with its mobilizers. This file decides which joints become
/// mobilizers and which closing rows the tree satisfies identically. Internal to the Simbody library.

#include "validation/simbody/rows.hpp"

namespace trivium::simbody {

/// How a body is attached to the tree: by a joint to the body `parent`, or, if `joint` is none, free relative
/// to Ground.
struct Branch {
  static constexpr int none = -1;
  int body = 0, parent = ground, joint = none;
  bool reversed = false;  ///< whether the parent is body j of the joint
};

/// The spanning tree, breadth first from the ground, so that parents come before children. Joints for which
/// Simbody has a mobilizer are used in file order. A body that no such joint reaches is free; if `use_joints`
/// is false, all bodies are.
std::vector<Branch> spanning_tree(const Model& model, bool use_joints);

/// Adds the body of a branch with its mobilizer. The frames M and F are chosen so that the coordinates are
/// regular at the model's state.
SimTK::MobilizedBodyIndex add_mobilizer(const Model& model, const Branch& branch, const BodyMap& bodies);

/// The pose of a body in Ground, and its velocity [angular; linear] in Ground, as the model states them.
SimTK::Transform pose_of(const Model& model, int body);
SimTK::SpatialVec velocity_of(const Model& model, int body);

/// Whether the forces of a row do no work along any mobility at the state. The limit is 1e-10 of the row's
/// forces, chosen by experiment; it lies above the rounding of rows that the tree satisfies identically. The
/// state must be realised to Stage::Velocity.
bool is_idle(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::Constraint& row,
             const SimTK::State& state);

/// Sets the coordinates and speeds of a mobilizer to the model's state.
void fit_mobilizer(const Model& model, const Branch& branch, const BodyMap& bodies, SimTK::State& state);

}  // namespace trivium::simbody
