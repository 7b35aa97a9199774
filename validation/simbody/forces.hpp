#pragma once
/// A model's effects as Simbody forces: Simbody's own elements where they exist (Gravity, ConstantForce,
/// ConstantTorque, TwoPointLinearSpring, TwoPointLinearDamper), else a Force::Custom that computes from
/// Simbody's state. Internal to the Simbody library.

#include "validation/simbody/mobilizer_tree.hpp"

namespace trivium::simbody {

/// Adds all effects. A torsional spring takes its angle and rate from the mobilizer's coordinate if its joint
/// is a mobilizer, else from the rotations of its bodies. Its torques act on the bodies, not on the
/// mobilizer, so that the mobilizer's reaction is the reaction of the joint alone.
void add_effects(const Model& model, const std::vector<Branch>& tree, const BodyMap& bodies,
                 SimTK::GeneralForceSubsystem& forces);

}  // namespace trivium::simbody
