#pragma once
/// The size of an error in units of the tolerances, by which methods on displacements accept a step.
/// Positions and velocities count alike.

#include <algorithm>
#include <cmath>

#include "integrators/contract/displacements.hpp"
#include "integrators/contract/tolerances.hpp"

namespace trivium::integrators {

/// Root mean square of an error of positions (`of_q`, a displacement) and of velocities (`of_v`), each number
/// divided by its tolerance. `sizes` are the position_sizes of the state at the start of the step; `v` and
/// `v_end` are the velocities at its start and end.
template <class S>
S in_tolerances(const Tolerances& tolerances, const StateVector<S>& sizes,
                const Eigen::Ref<const StateVector<S>>& v, const Eigen::Ref<const StateVector<S>>& v_end,
                const StateVector<S>& of_q, const StateVector<S>& of_v) {
  using std::abs, std::max, std::sqrt;
  const S atol(tolerances.atol), rtol(tolerances.rtol);
  S sum(0);
  for (Eigen::Index k = 0; k < of_v.size(); ++k) {
    const S velocity = of_v[k] / (atol + rtol * max(S(abs(v[k])), S(abs(v_end[k])))),
            position = of_q[k] / (atol + rtol * sizes[k]);
    sum += velocity * velocity + position * position;
  }
  return sqrt(sum / static_cast<double>(2 * of_v.size()));
}

}  // namespace trivium::integrators
