#pragma once
/// Whether a mechanism is so far from the global origin that the rounding of its positions may have made a
/// step fail. Iterations onto the constraints cannot get below this rounding.

#include <fmt/format.h>

#include <limits>
#include <string>
#include <vector>

#include "base/raise.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/reach.hpp"

namespace trivium {

/// A message that names the farthest body if the rounding of its position is above 1e-12 of the size of the
/// mechanism; empty if it is not.
template <class Types>
std::string far_from_origin(const Mechanism<double, Types>& mechanism, const MechanismState<double>& state) {
  const std::vector<double> reach = reaches(mechanism);
  double farthest = 0, size = 0;
  int body = 0;
  for (int b = 0; b < mechanism.nb(); ++b) {
    const double distance = state.pose[b].r.norm();
    if (distance > farthest) body = b;
    raise(farthest, distance);
    raise(size, (state.pose[b].r - state.pose[0].r).norm() + reach[b]);
  }
  const double rounding = std::numeric_limits<double>::epsilon() * farthest;
  if (!(rounding > 1e-12 * size)) return {};
  return fmt::format(
      "body \"{}\" is {:.1e} m from the global origin, where positions are rounded by {:.1e} m, too coarse "
      "for a mechanism of {:.1e} m; move the origin nearer to it, or take another method",
      mechanism.body_names[body], farthest, rounding, size);
}

}  // namespace trivium
