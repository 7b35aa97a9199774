#pragma once
/// Creates a std::variant that holds the n-th type of its list, with n known only at run time. The scene
/// reader and tests loop over all types of a list by n; a switch over the types could miss one.

#include <cstddef>
#include <utility>
#include <variant>

namespace trivium {

/// A variant that holds a default-constructed value of its n-th type (from 0). Throws std::bad_variant_access
/// if n is out of range.
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
