#pragma once
/// A model's effects as Simbody forces: its own elements where they exist (Gravity, ConstantForce,
/// ConstantTorque, TwoPointLinearSpring, TwoPointLinearDamper), else Force::Custom computing from Simbody's
/// state. Internal to the Simbody library.

#include "validation/simbody/mobilizer_tree.hpp"

namespace trivium::simbody {

/// Adds all effects. A torsional spring whose joint is a mobilizer takes angle and rate from the mobilizer's
/// coordinate, any other from the rotations of its bodies; its torques act on the bodies, so that the
/// mobilizer's reaction is the joint's alone.
void add_effects(const Model& model, const std::vector<Branch>& tree, const BodyMap& bodies,
                 SimTK::GeneralForceSubsystem& forces);

}  // namespace trivium::simbody
