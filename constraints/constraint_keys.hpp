#pragma once
/// How a basic constraint shows its parts besides its bodies: of one, or of several of one type side by side.
/// Casts and batches, and for those that a scene file names reader, writer, checks and random scenes go by
/// this alone. A visitor has
///
///   vector_i(a_bar...), vector_j(a_bar...)   a vector of body i, of body j: the key `vector` of its side
///   point_i(s_bar...), point_j(s_bar...)     a point: the key `point`
///   need(key, value...), may(key, value...)  the function of time `f`, or the global vector `direction`;
///                                            what `may` shows is 0 where the file has none
///
/// One that files name has at most one vector and one point on a side, and no other keys.

#include <string_view>

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

/// use(part...) for every part: what is common to visitors that take all parts alike.
template <class Use>
struct ConstraintParts {
  const Use& use;

  void vector_i(auto&... a_bar) const { use(a_bar...); }
  void vector_j(auto&... a_bar) const { use(a_bar...); }
  void point_i(auto&... s_bar) const { use(s_bar...); }
  void point_j(auto&... s_bar) const { use(s_bar...); }
  void need(std::string_view, auto&... value) const { use(value...); }
  void may(std::string_view, auto&... value) const { use(value...); }
};

/// use(part...) for every part of one basic constraint or of several of its type.
template <class Use, class C, class... Others>
void show_constraint_parts(const Use& use, C& constraint, Others&... others) {
  BodyPair::show_parts(use, constraint, others...);
  C::keys(ConstraintParts<Use>{use}, constraint, others...);
}

}  // namespace trivium
