#pragma once
/// The ways in which a model is rebuilt in Simbody: which joints become mobilizers and which rows become
/// constraints (mobilizer_tree.hpp decides for each joint). Plain C++17, like model.hpp.

#include <stdexcept>
#include <vector>

#include "validation/simbody/model.hpp"

namespace trivium::simbody {

/// How a model is rebuilt.
enum class Way {
  /// A spanning tree of joints as mobilizers, and closing joints as custom constraints. Closing rows that the
  /// tree satisfies identically (for example a second hinge on the same axis) are disabled. Simbody decides
  /// the rank relative to the largest row: if all closing rows vanish, it would treat their rounding errors
  /// as constraints.
  mobilizers,
  free_bodies,  ///< every body is free; every row is a custom constraint
  built_in      ///< every body is free; rows are Simbody's own constraints if these exist, else custom ones
};

/// The joints that become mobilizers, in the order of the tree; empty for the ways with free bodies.
std::vector<int> mobilizers(const Model& model, Way way);

/// The error of a model that Simbody cannot build or solve; Simbody's message on one line.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace trivium::simbody
