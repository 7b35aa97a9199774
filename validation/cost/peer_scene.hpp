#pragma once
/// A scene in the form that other engines get: a spanning tree of joints with relative coordinates that
/// vanish at the scene's state, and the closing joints. Plain C++17 data.

#include <string>
#include <vector>

#include "validation/cost/engine.hpp"
#include "validation/simbody/model.hpp"

namespace trivium::cost {

using simbody::ground;
using Quaternion = std::array<double, 4>;  ///< unit quaternion; e0 first

/// The joint by which a body is attached to its parent in the tree.
struct TreeJoint {
  enum class Kind { axes, ball, free };
  /// One axis of rotation or translation, in the child's frame at the scene's state. If a joint has several
  /// axes, they act in order, starting at the parent.
  struct Axis {
    bool slides = false;
    Vector3 direction{};
    double rate = 0;
  };

  int body = 0, parent = ground;
  int joint = -1;         ///< index of the joint in the model; -1: no joint, the body is free
  bool reversed = false;  ///< whether the parent is body j of the joint
  Vector3 position{};     ///< origin of the child's frame, in the parent's frame, at the scene's state
  Quaternion orientation{1, 0, 0, 0};
  Vector3 point{};  ///< point of the joint, in the child's frame
  Kind kind = Kind::axes;
  std::vector<Axis> axes;      ///< empty: welded
  Vector3 angular_velocity{};  ///< for ball and free: relative to the parent, in the child's frame
  Vector3 velocity{};          ///< for free: velocity of the child's origin, global frame
};

/// A force and a torque on a body, global frame, at the centre of mass.
struct Load {
  Vector3 force{}, torque{};
};

struct PeerScene {
  simbody::Model model;
  Vector3 gravity{};
  std::vector<Load> loads;      ///< per body, by effects other than gravity; empty if all are zero
  std::vector<TreeJoint> tree;  ///< parents before children
  std::vector<int> closings;    ///< joints of the model that are not in the tree
  /// All joints are revolutes with parallel axes: a closing joint then only needs to fix its point.
  bool is_planar = false;
};

}  // namespace trivium::cost
