#pragma once
/// A scene as other engines are told of it: a spanning tree of joints in relative coordinates that all vanish
/// at the scene's state, and what closes its loops. Plain C++17 data.

#include <string>
#include <vector>

#include "validation/cost/engine.hpp"
#include "validation/simbody/model.hpp"

namespace trivium::cost {

using simbody::ground;
using Quaternion = std::array<double, 4>;  ///< unit, e0 first

/// How a body hangs in the tree.
struct TreeJoint {
  enum class Kind { axes, ball, free };
  /// A hinge or a slide, in the frame of the child at the scene's state; several act one after the other, the
  /// parent's first.
  struct Axis {
    bool slides = false;
    Vector3 direction{};
    double rate = 0;
  };

  int body = 0, parent = ground;
  int joint = -1;         ///< of the model, -1: none, the body is free
  bool reversed = false;  ///< the parent is the joint's body j
  Vector3 position{};     ///< of the child's frame in the parent's, at the scene's state
  Quaternion orientation{1, 0, 0, 0};
  Vector3 point{};  ///< of the joint, in the child's frame
  Kind kind = Kind::axes;
  std::vector<Axis> axes;      ///< none: welded
  Vector3 angular_velocity{};  ///< ball, free: relative, in the child's frame
  Vector3 velocity{};          ///< free: of the child's origin, global
};

/// Global, at the centre of mass.
struct Load {
  Vector3 force{}, torque{};
};

struct PeerScene {
  simbody::Model model;
  Vector3 gravity{};
  std::vector<Load> loads;  ///< what effects other than gravity do to each body at this state; empty: none
  std::vector<TreeJoint> tree;  ///< parents before children
  std::vector<int> closings;    ///< joints of the model that are not in the tree
  /// All joints are revolutes about one direction: where one closes a loop, its point is all that it adds.
  bool is_planar = false;
};

}  // namespace trivium::cost
