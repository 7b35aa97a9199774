#pragma once
/// Converts a mechanism to another Scalar. If this Scalar is a Batch, every lane gets the same numbers. The
/// members are visited by show_parts (parts.hpp), so that a new member needs no change here.

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "mechanism/parts.hpp"

namespace trivium {

namespace detail {

/// A mechanism over To with as many bodies, rows, joints and effects of each type as `from`. Its name, its
/// rank tolerance and the names of its effects are copied; all parts that show_parts visits keep their
/// initial values.
template <class To, class ToTypes, class From, class FromTypes>
Mechanism<To, ToTypes> same_structure(const Mechanism<From, FromTypes>& from) {
  Mechanism<To, ToTypes> to;
  to.name = from.name;
  to.rank_tolerance = from.rank_tolerance;
  to.body_names.resize(from.body_names.size());
  to.row_names.resize(from.row_names.size());
  to.bodies.resize(from.bodies.size());
  to.joints.resize(from.joints.size());
  to.rows.reserve(from.rows.size());
  const auto add_row = [&]<template <class> class Row>(const Row<From>&) {
    to.rows.emplace_back(std::in_place_type<Row<To>>);
  };
  for (const auto& row : from.rows) std::visit(add_row, row);
  const auto resize = [](const auto& from_list, auto& to_list) {
    to_list.resize(from_list.size());
    for (std::size_t k = 0; k < from_list.size(); ++k) to_list[k].name = from_list[k].name;
  };
  [&]<std::size_t... n>(std::index_sequence<n...>) {
    (resize(std::get<n>(from.effects.lists()), std::get<n>(to.effects.lists())), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(from.effects.lists())>>>{});
  return to;
}

/// A mechanism of the same structure, with all parts converted to To.
template <class To, class ToTypes, class From, class FromTypes>
Mechanism<To, ToTypes> cast_to(const Mechanism<From, FromTypes>& from) {
  Mechanism<To, ToTypes> to = same_structure<To, ToTypes>(from);
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

}  // namespace detail

/// The same mechanism over the scalar type To; its numbers are rounded to To.
template <class To, class From, class Types>
Mechanism<To, Types> mechanism_cast(const Mechanism<From, Types>& from) {
  return detail::cast_to<To, Types>(from);
}

/// The same mechanism with larger lists of types, such as `StandardConstraints::With<MyConstraint>`. The
/// lists of MoreTypes must begin with the types of the mechanism's own lists, in the same order; new types
/// follow.
template <class MoreTypes, class S, class Types>
Mechanism<S, MoreTypes> with_more_types(const Mechanism<S, Types>& from) {
  return detail::cast_to<S, MoreTypes>(from);
}

}  // namespace trivium
