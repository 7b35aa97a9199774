#pragma once
/// Shows every part of a mechanism to a visitor, or of several mechanisms of one structure side by side, be
/// they in different Scalars. A part is a number, a vector or matrix, or what no Scalar changes: an index, a
/// type, a name, a function of time. Each type lists its own parts in `show_parts`; a mechanism's own name
/// and those of effects, which only messages need, are no parts.

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace trivium {

namespace detail {

template <class Use, class List, class... Lists>
void show_parts_of_all(const Use& use, List& list, Lists&... lists) {
  for (std::size_t k = 0; k < list.size(); ++k) List::value_type::show_parts(use, list[k], lists[k]...);
}

template <class Use, class List, class... Lists>
void show_parts_of_effects(const Use& use, List& list, Lists&... lists) {
  for (std::size_t k = 0; k < list.size(); ++k) show_effect_parts(use, list[k], lists[k]...);
}

/// Of a variant whose type is the same in all lists.
template <class Use, class Row, class... Rows>
void show_parts_of_row(const Use& use, Row& row, Rows&... rows) {
  const auto of = [&]<std::size_t n>(std::integral_constant<std::size_t, n>) {
    if (row.index() == n) show_constraint_parts(use, std::get<n>(row), std::get<n>(rows)...);
  };
  [&]<std::size_t... n>(std::index_sequence<n...>) { (of(std::integral_constant<std::size_t, n>{}), ...); }
  (std::make_index_sequence<std::variant_size_v<std::remove_const_t<Row>>>{});
}

}  // namespace detail

/// use(part, parts...) for every part of the first mechanism and those that correspond to it in the others.
template <class Use, class M, class... Others>
void show_parts(const Use& use, M& mechanism, Others&... others) {
  for (std::size_t k = 0; k < mechanism.body_names.size(); ++k)
    use(mechanism.body_names[k], others.body_names[k]...);
  for (std::size_t k = 0; k < mechanism.row_names.size(); ++k)
    use(mechanism.row_names[k], others.row_names[k]...);
  detail::show_parts_of_all(use, mechanism.bodies, others.bodies...);
  for (std::size_t k = 0; k < mechanism.rows.size(); ++k)
    detail::show_parts_of_row(use, mechanism.rows[k], others.rows[k]...);
  detail::show_parts_of_all(use, mechanism.joints, others.joints...);
  [&]<std::size_t... n>(std::index_sequence<n...>) {
    const auto of = [&]<std::size_t type>(std::integral_constant<std::size_t, type>) {
      detail::show_parts_of_effects(use, std::get<type>(mechanism.effects.lists()),
                                    std::get<type>(others.effects.lists())...);
    };
    (of(std::integral_constant<std::size_t, n>{}), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(mechanism.effects.lists())>>>{});
}

}  // namespace trivium
