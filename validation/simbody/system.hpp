#pragma once
/// A model rebuilt in Simbody: a spanning tree of mobilizers, constraints for the remaining rows, forces, and
/// their common state. Closing rows that the tree satisfies identically are disabled. Internal to the Simbody
/// library.

#include <Simbody.h>

#include <string>
#include <vector>

#include "validation/simbody/mobilizer_tree.hpp"
#include "validation/simbody/way.hpp"

namespace trivium::simbody {

/// The system at the model's state, realised to Stage::Acceleration.
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
  std::vector<const Branch*> branch_of_joint;  ///< null if the joint did not become a mobilizer
  std::vector<LinkedConstraint> constraints;
  std::vector<int> idle_rows;
  SimTK::State state;

 private:
  void disable_idle_rows();
};

/// A message of Simbody on one line, without the leading place in Simbody's source.
std::string on_one_line(const std::string& message);

}  // namespace trivium::simbody
