#pragma once
/// `show_parts` presents every part of a mechanism to a visitor, or the corresponding parts of several
/// mechanisms of equal structure, which may have different Scalars. A part is a number, vector or matrix over
/// the Scalar, or an index, type, name or function of time, which is the same over every Scalar. The names of
/// the mechanism and of effects are not parts. Each type lists its members in its own `show_parts` or `keys`.

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace trivium {

namespace detail {

/// The parts of all bodies, or of all joints.
template <class Use, class List, class... Lists>
void show_parts_of_all(const Use& use, List& list, Lists&... lists) {
  for (std::size_t k = 0; k < list.size(); ++k) List::value_type::show_parts(use, list[k], lists[k]...);
}

/// The parts of all effects of one type.
template <class Use, class List, class... Lists>
void show_parts_of_effects(const Use& use, List& list, Lists&... lists) {
  for (std::size_t k = 0; k < list.size(); ++k) show_effect_parts(use, list[k], lists[k]...);
}

/// The parts of rows; all variants must hold the same type.
template <class Use, class Row, class... Rows>
void show_parts_of_row(const Use& use, Row& row, Rows&... rows) {
  const auto of = [&]<std::size_t n>(std::integral_constant<std::size_t, n>) {
    if (row.index() == n) show_constraint_parts(use, std::get<n>(row), std::get<n>(rows)...);
  };
  [&]<std::size_t... n>(std::index_sequence<n...>) { (of(std::integral_constant<std::size_t, n>{}), ...); }
  (std::make_index_sequence<std::variant_size_v<std::remove_const_t<Row>>>{});
}

}  // namespace detail

/// Calls use(part, parts...) for every part of `mechanism` and the corresponding parts of `others`.
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
