#pragma once
/// The row analysis of a model with any types of constraints and effects. row_analysis.cpp compiles it for
/// the types of the library. Include this file for other types.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "formulations/analysis/magnitude_bounds.hpp"
#include "formulations/analysis/row_analysis.hpp"

namespace trivium {

namespace detail {

/// The message about rows that contradict each other, with their names.
inline std::string contradiction(const std::vector<std::string>& row_names, const RowAnalysis& rows) {
  std::string names;
  for (int k : rows.contradictory) names += (names.empty() ? "" : ", ") + row_names[k];
  return fmt::format(
      "the rows contradict each other, so no acceleration exists; in contradiction to earlier rows: {}; "
      "remove a row, or make their functions of time consistent",
      names);
}

}  // namespace detail

template <class Types>
RowAnalysis analyse_rows(const Model<double, Types>& model) {
  const auto& [mechanism, state] = model;
  const int unknowns = 6 * mechanism.nb() + mechanism.nc();
  if (unknowns > most_dense_unknowns)
    throw ModelError(
        {mechanism.name},
        fmt::format("{} bodies and {} rows make a dense augmented matrix of {} unknowns; the dense printed "
                    "solver accepts at most {}; take fewer bodies or the structured solver",
                    mechanism.nb(), mechanism.nc(), unknowns, most_dense_unknowns));
  try {
    TangentSystem system = tangent_system(mechanism, state);
    add_magnitude_bounds(mechanism, state, system);
    RowAnalysis rows = analyse_rows(system);
    rows.warnings = narrow_row_warnings(mechanism.row_names, rows);
    if (!rows.contradictory.empty()) throw ModelError(detail::contradiction(mechanism.row_names, rows));
    return rows;
  } catch (const ModelError& error) {
    throw ModelError({mechanism.name, state.t}, error);
  }
}

}  // namespace trivium
