#pragma once
/// The ways in which a model is rebuilt in Simbody: what becomes a mobilizer, and what a constraint
/// (mobilizer_tree.hpp decides for each joint). Plain C++17, like model.hpp.

#include <stdexcept>
#include <vector>

#include "validation/simbody/model.hpp"

namespace trivium::simbody {

/// How a model is rebuilt.
enum class Way {
  /// A spanning tree of joints as mobilizers; what closes it, as custom constraints. Closing rows that the
  /// tree satisfies identically (a second hinge on the same axis) are disabled: Simbody decides rank relative
  /// to the largest row, so that where all closing rows vanish it takes their rounding for a constraint.
  mobilizers,
  free_bodies,  ///< every body free on Ground; every row a custom constraint
  built_in      ///< every body free on Ground; Simbody's own constraints where one exists, else custom ones
};

/// The joints that become mobilizers, in the order of the tree; none where the way has free bodies only.
std::vector<int> mobilizers(const Model& model, Way way);

/// Simbody would not build or solve the model; its message, on one line.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace trivium::simbody
