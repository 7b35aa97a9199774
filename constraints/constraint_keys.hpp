#pragma once
/// The function `keys` of a basic constraint presents its parts, except its bodies, to a visitor. It takes
/// one constraint, or several of one type whose corresponding parts are passed together. Casts, batches, and
/// the reader, writer, checks and random generator of scenes reach the parts by `keys` alone. A visitor has
///
///     vector_i(a_bar...), vector_j(a_bar...)   a vector of body i or j; key `vector` of that side in a file
///     point_i(s_bar...), point_j(s_bar...)     a point of body i or j; key `point` of that side
///     need(key, value...)                      a function of time or a global vector
///     may(key, value...)                       the same, but optional in a file; default 0
///
/// A constraint of scene files has at most one vector and one point per body. Its function of time has the
/// key `f`, its global vector the key `direction`, and it has no other parts. A constraint that scene files
/// cannot contain is free of these limits: the function of TurningDP1 has the key `alpha`.

#include <string_view>

#include "constraints/basic_constraint_parts.hpp"

namespace trivium {

/// A visitor that treats all parts alike: calls use(part...) for every part.
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

/// Calls use(part...) for every part, also the body indices, of one constraint or of several of its type.
template <class Use, class C, class... Others>
void show_constraint_parts(const Use& use, C& constraint, Others&... others) {
  BodyPair::show_parts(use, constraint, others...);
  C::keys(ConstraintParts<Use>{use}, constraint, others...);
}

}  // namespace trivium
