#pragma once
/// Common include of the files of basic constraints: the bodies of a row, features and functions of time. The
/// members that a basic constraint must have are listed in basic_constraint.hpp.

#include "bodies/numbers/time_function.hpp"
#include "bodies/numbers/vectors.hpp"
#include "constraints/feature.hpp"

namespace trivium {

/// The two bodies of a constraint row.
struct BodyPair {
  int i = 0, j = 0;  ///< indices of bodies in the mechanism; nb, one past the last body, is the ground

  /// Calls use(a.m, b.m, ...) for every member m, where a, b, ... are the given pairs.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.i...);
    use(p.j...);
  }
};

}  // namespace trivium
