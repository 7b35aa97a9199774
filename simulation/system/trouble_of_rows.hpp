#pragma once
/// Whether dependent rows may have ended a motion: at a singular position, where rows become dependent that
/// are independent elsewhere, and the mechanism can go on in more than one way, or because a driver asks for
/// something else than the rows that it depends on.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "formulations/analysis/row_analysis.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// A message about drivers that depend on other rows and contradict them; empty if there are none. `drivers`
/// are rows.
inline std::string contradicting_drivers(const std::vector<std::string>& row_names, const RowAnalysis& rows,
                                         const std::vector<int>& drivers, double t) {
  for (const int row : rows.contradictory) {
    // the rows that its dependence involves
    const VectorX<double> share = (rows.null_basis * rows.null_basis.row(row).transpose()).cwiseAbs();
    std::vector<std::string> involved;
    for (const int driver : drivers)
      if (share[driver] > 1e-6 * share.maxCoeff())
        involved.push_back(fmt::format("driver \"{}\"", row_names[driver]));
    if (!involved.empty())
      return fmt::format(
          "{}: what is demanded at t = {} contradicts the other rows, so no acceleration satisfies all. Make "
          "the functions of time consistent, or leave a driver out",
          fmt::join(involved, ", "), t);
  }
  return {};
}

/// A message if the rows are much closer to being dependent than at the start, or if drivers contradict the
/// rows that they depend on; empty if not. `drivers` are rows.
template <class Types>
std::string trouble_of_rows(const Mechanism<double, Types>& mechanism, const std::vector<int>& drivers,
                            const MechanismState<double>& start, const MechanismState<double>& now) {
  // Each row is divided by its size, which depends on the position. So the condition number of three rows of
  // a spherical joint changes by 40 where the body is slender.
  constexpr double much = 1000;
  if (mechanism.nc() == 0) return {};
  const RowAnalysis before = analyse_rows(tangent_system(mechanism, start)),
                    here = analyse_rows(tangent_system(mechanism, now));
  if (here.rank >= before.rank && here.kappa <= much * before.kappa)
    return contradicting_drivers(mechanism.row_names, here, drivers, now.t);
  return fmt::format(
      "near a singular position, where rows become dependent and the mechanism can go on in more than one "
      "way: since the start {}. dopri5, rkf78 and rattle pass most singular positions",
      here.rank < before.rank
          ? fmt::format("the rank of the rows has fallen from {} to {}", before.rank, here.rank)
          : fmt::format("the condition number of the rows has grown from {:.1e} to {:.1e}", before.kappa,
                        here.kappa));
}

}  // namespace trivium
