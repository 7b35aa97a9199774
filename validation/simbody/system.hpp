#pragma once
/// A model rebuilt in Simbody: a spanning tree of mobilizers, constraints for the rows that are left, forces,
/// and the state that all of them share. Closing rows that the tree satisfies identically are disabled.
/// Internal to the Simbody library.

#include <Simbody.h>

#include <string>
#include <vector>

#include "validation/simbody/mobilizer_tree.hpp"
#include "validation/simbody/way.hpp"

namespace trivium::simbody {

/// At the model's state, realised to Stage::Acceleration.
struct System {
  System(const Model& of, Way way);
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  const Model& model;
  SimTK::MultibodySystem multibody;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  BodyMap bodies;
  std::vector<Branch> tree;
  std::vector<const Branch*> branch_of_joint;  ///< where the joint became a mobilizer
  std::vector<LinkedConstraint> constraints;
  std::vector<int> idle_rows;
  SimTK::State state;

 private:
  void disable_idle_rows();
};

/// Simbody's messages run over lines and begin with the place in its source.
std::string on_one_line(const std::string& message);

}  // namespace trivium::simbody
