#pragma once
/// A mechanism's numbers in another Scalar, such as the same number in every lane of a batch. Each type shows
/// its numbers to a visitor (parts.hpp), so no list of members stands here.

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "mechanism/parts.hpp"

namespace trivium {

namespace detail {

/// A mechanism in To that has as many bodies, rows, joints and effects of each type as another, and its name
/// and the names of its effects; the parts of these are not set.
template <class To, class From>
Mechanism<To> same_structure(const Mechanism<From>& from) {
  Mechanism<To> to;
  to.name = from.name;
  to.body_names.resize(from.body_names.size());
  to.row_names.resize(from.row_names.size());
  to.bodies.resize(from.bodies.size());
  to.joints.resize(from.joints.size());
  to.rows.reserve(from.rows.size());
  const auto add_row = [&]<template <class> class Row>(const Row<From>&) {
    to.rows.emplace_back(std::in_place_type<Row<To>>);
  };
  for (const BasicConstraint<From>& row : from.rows) std::visit(add_row, row);
  const auto resize = [](const auto& from_list, auto& to_list) {
    to_list.resize(from_list.size());
    for (std::size_t k = 0; k < from_list.size(); ++k)
      if constexpr (requires { to_list[k].name; }) to_list[k].name = from_list[k].name;
  };
  [&]<std::size_t... n>(std::index_sequence<n...>) {
    (resize(std::get<n>(from.effects.lists()), std::get<n>(to.effects.lists())), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(to.effects.lists())>>>{});
  return to;
}

}  // namespace detail

template <class To, class From>
Mechanism<To> mechanism_cast(const Mechanism<From>& from) {
  Mechanism<To> to = detail::same_structure<To>(from);
  const auto convert = []<class Part, class Converted>(const Part& part, Converted& converted) {
    if constexpr (std::is_same_v<Part, From>)
      converted = To(part);
    else if constexpr (requires { typename Part::Scalar; })
      converted = part.unaryExpr([](const From& x) { return To(x); });
    else
      converted = part;
  };
  show_parts(convert, from, to);
  return to;
}

}  // namespace trivium
