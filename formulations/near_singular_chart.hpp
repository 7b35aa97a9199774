#pragma once
/// Names the body whose chart is near its singularity, as the cause of a failure. Formulations without charts
/// name none.

#include <fmt/format.h>

#include <concepts>
#include <string>
#include <vector>

#include "formulations/body_state.hpp"
#include "formulations/formulation.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// A message about the body nearest to the singularity of its chart at time t [s], if it is nearer than
/// `within` [rad for Euler angles]; empty if there is none.
template <Formulation F>
std::string near_singular_chart(const MechanismOf<F>& mechanism, const std::vector<BodyState<F>>& state,
                                const typename F::Scalar& t, const typename F::Scalar& within) {
  if constexpr (std::same_as<typename F::Chart, NoChart>) {
    return {};
  } else {
    typename F::Scalar nearest = within;
    int body = -1;
    for (int b = 0; b < mechanism.nb(); ++b) {
      const typename F::Scalar distance = F::chart_distance(state[b].chart, state[b].q);
      if (!(distance < nearest)) continue;
      nearest = distance;
      body = b;
    }
    if (body < 0) return {};
    return fmt::format(
        "body \"{}\" at t = {}: the coordinates of {} are at a distance of {:.1e} from their singularity; "
        "leave re-framing on, or start in another chart (for Euler angles: another sequence)",
        mechanism.body_names[body], static_cast<double>(t), F::name, static_cast<double>(nearest));
  }
}

}  // namespace trivium
