#pragma once
/// Adds bodies and constraints to a model in C++, in addition to those of its scene. A new body takes the
/// index of the ground, which becomes one higher in all references to the ground.

#include <string>
#include <utility>
#include <variant>

#include "mechanism/model.hpp"

namespace trivium {

namespace detail {

/// A visitor of effects (effect_keys.hpp) that replaces the body index `from` by `to`.
struct MoveGround : ValueVisitor<MoveGround> {
  int from, to;

  MoveGround(int before, int after) : from(before), to(after) {}

  void move(int& body) const { body = body == from ? to : body; }
  void body(std::string_view, int& index) const { move(index); }
  void point(std::string_view, auto& end) const { move(end.body); }
  void joint(std::string_view, auto& angle) const { move(angle.i), move(angle.j); }
  void value(std::string_view, auto&) const {}
};

/// A visitor of a basic constraint (constraint_keys.hpp) that copies its points into two joint frames, where
/// reactions are evaluated.
template <class Scalar>
struct PointsOf {
  JointFrame<Scalar>&i, &j;

  void vector_i(const auto&) const {}
  void vector_j(const auto&) const {}
  void point_i(const Vector3<Scalar>& s_bar) const { i.point = s_bar; }
  void point_j(const Vector3<Scalar>& s_bar) const { j.point = s_bar; }
  void need(std::string_view, const auto&) const {}
  void may(std::string_view, const auto&) const {}
};

}  // namespace detail

/// Adds a body without constraints, with its pose and twist at the time of the model's state. Returns its
/// index, which was the index of the ground; the ground's index grows by one.
template <class S, class Types>
int add_body(Model<S, Types>& model, std::string name, const RigidBody<S>& body, const Pose<S>& pose,
             const Twist<S>& twist) {
  Mechanism<S, Types>& m = model.mechanism;
  const int index = m.ground();
  detail::MoveGround ground(index, index + 1);
  const auto move_both = [&](BodyPair& pair) { ground.move(pair.i), ground.move(pair.j); };
  for (auto& row : m.rows) std::visit(move_both, row);
  for (auto& joint : m.joints) move_both(joint);
  const auto move_effects = [&](auto& list) {
    for (auto& effect : list) effect.keys(ground, effect);
  };
  std::apply([&](auto&... lists) { (move_effects(lists), ...); }, m.effects.lists());
  m.bodies.push_back(body);
  if (m.body_names.empty()) m.body_names.emplace_back("ground");
  m.body_names.insert(m.body_names.end() - 1, std::move(name));
  model.state.pose.push_back(pose);
  model.state.twist.push_back(twist);
  return index;
}

/// Adds a constraint of one row, of any type in the mechanism's list. Like a basic constraint of a scene it
/// also becomes a joint of one row, so that the structured solver and the reactions include it.
template <class Scalar, class Types>
void add_constraint(Mechanism<Scalar, Types>& mechanism, std::string name,
                    typename Mechanism<Scalar, Types>::Row row) {
  Joint<Scalar> joint;
  static_cast<BodyPair&>(joint) = bodies_of(row);
  joint.name = name;
  joint.type = {JointType::basic, static_cast<int>(row.index())};
  joint.first_row = mechanism.nc();
  joint.rows = 1;
  const detail::PointsOf<Scalar> points{joint.frame_i, joint.frame_j};
  std::visit([&](const auto& one) { one.keys(points, one); }, row);
  mechanism.joints.push_back(std::move(joint));
  mechanism.rows.push_back(std::move(row));
  mechanism.row_names.push_back(std::move(name));
}

}  // namespace trivium
