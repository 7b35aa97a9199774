#pragma once
/// What the file of a basic constraint begins with: the bodies of a row, features, functions of time. What
/// one must have is said in basic_constraint.hpp, where it is entered in the list.

#include "bodies/numbers/time_function.hpp"
#include "bodies/numbers/vectors.hpp"
#include "constraints/feature.hpp"

namespace trivium {

/// The bodies of a row: indices into the mechanism's bodies, the last of which is the ground.
struct BodyPair {
  int i = 0, j = 0;

  /// use(part...) for every part of one pair or of several side by side.
  template <class Use, class... Part>
  static void show_parts(const Use& use, Part&... p) {
    use(p.i...);
    use(p.j...);
  }
};

}  // namespace trivium
