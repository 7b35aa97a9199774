#pragma once
/// A constraint of one row added to a mechanism in C++, as a scene file's basic constraints are: its row, its
/// name, and the joint that it is, so that solvers plan with it and reactions are told of it.

#include <string>
#include <utility>

#include "mechanism/mechanism.hpp"

namespace trivium {

/// Any row of the mechanism's list. To the graph it is a cd, which of all basic constraints may see most:
/// bodies that move together, too.
template <class Scalar, class Types>
void add_constraint(Mechanism<Scalar, Types>& mechanism, std::string name,
                    typename Mechanism<Scalar, Types>::Row row) {
  Joint<Scalar> joint;
  static_cast<BodyPair&>(joint) = bodies_of(row);
  joint.name = name;
  joint.type = ConstraintType::cd;
  joint.first_row = mechanism.nc();
  joint.rows = 1;
  mechanism.joints.push_back(std::move(joint));
  mechanism.rows.push_back(std::move(row));
  mechanism.row_names.push_back(std::move(name));
}

}  // namespace trivium
