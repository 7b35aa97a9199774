#pragma once
/// Whether a singular position may have ended a motion. There rows become dependent that are independent
/// elsewhere, and the mechanism can go on in more than one way.

#include <fmt/format.h>

#include <string>

#include "formulations/analysis/row_analysis.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// A message if the rows are much closer to being dependent than at the start; empty if not.
template <class Types>
std::string near_singular_position(const Mechanism<double, Types>& mechanism,
                                   const MechanismState<double>& start, const MechanismState<double>& now) {
  // Each row is divided by its size, which depends on the position. So the condition number of three rows of
  // a spherical joint changes by 40 where the body is slender.
  constexpr double much = 1000;
  if (mechanism.nc() == 0) return {};
  const RowAnalysis before = analyse_rows(tangent_system(mechanism, start)),
                    here = analyse_rows(tangent_system(mechanism, now));
  if (here.rank >= before.rank && here.kappa <= much * before.kappa) return {};
  return fmt::format(
      "near a singular position, where rows become dependent and the mechanism can go on in more than one "
      "way: since the start {}. dopri5, rkf78 and rattle pass most singular positions",
      here.rank < before.rank
          ? fmt::format("the rank of the rows has fallen from {} to {}", before.rank, here.rank)
          : fmt::format("the condition number of the rows has grown from {:.1e} to {:.1e}", before.kappa,
                        here.kappa));
}

}  // namespace trivium
