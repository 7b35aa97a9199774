#pragma once
/// A variant of the type that stands at a place of its list, where the place is known at run time alone. So
/// readers and tests go through a list of types without a switch that could miss one.

#include <cstddef>
#include <utility>
#include <variant>

namespace trivium {

/// The n-th type's default. Throws a std::bad_variant_access where there is no such type.
template <class Variant>
Variant emplaced(std::size_t n) {
  Variant value;
  const bool is_found = [&]<std::size_t... k>(std::index_sequence<k...>) {
    return ((n == k && (value.template emplace<k>(), true)) || ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>{});
  if (!is_found) throw std::bad_variant_access();
  return value;
}

}  // namespace trivium
