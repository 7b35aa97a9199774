#pragma once
/// Changes of chart (re-framing) along a motion. Formulations without charts (NoChart) do nothing here.

#include <fmt/format.h>

#include <concepts>
#include <string>
#include <vector>

#include "formulations/euler_chart_choice.hpp"
#include "simulation/system/state_layout.hpp"

namespace trivium {

/// Gives a body whose Euler angles come nearer to their singularity than reframing_distance another chart,
/// chosen as at the start (formulations/euler_chart_choice.hpp), in which its orientation and rates in y are
/// rewritten. If the user keeps the charts, `near_singularity` reports such a body.
template <Formulation F>
class ChartSwitching {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  explicit ChartSwitching(const ChartOptions& options) : options_(options) {}

  bool is_on() const { return options_.reframe; }
  /// The number of changes so far.
  int changes() const { return changes_; }

  /// Changes the charts of bodies that are near their singularity, in `state`, which must be the state of y,
  /// and in y. Returns whether any coordinates of y changed. Throws a ModelError that names the body if no
  /// chart is far enough from its singularity.
  bool change(const MechanismOf<F>& mechanism, const S& t, const StateLayout<F>& layout,
              std::vector<BodyState<F>>& state, StateVector& y) {
    if constexpr (std::same_as<typename F::Chart, NoChart>) return false;
    bool changed = false;
    for (int b = 0; b < layout.nb(); ++b) {
      BodyState<F>& body = state[b];
      if (!(F::chart_distance(body.chart, body.q) < S(reframing_distance))) continue;
      const Vector4<S> p = F::to_euler_parameters(body.chart, body.q);
      const Vector3<S> omega_bar = kinematics_of(body).omega_bar;
      try {
        body.chart = F::choose_chart(options_, p);
      } catch (const ModelError& error) {
        throw ModelError({fmt::format("body \"{}\"", mechanism.body_names[b]), static_cast<double>(t)},
                         error);
      }
      body.q = F::from_pose(body.chart, p, omega_bar);
      layout.place(y, b).tail(F::orientation_size) = F::orientation_of(body.chart, p);
      layout.rate(y, b).tail(F::rotational_unknowns) = F::velocity_of(body.chart, body.q);
      changed = true;
      ++changes_;
    }
    return changed;
  }

  /// A message about the first body that is near the singularity of its chart; empty if there is none.
  static std::string near_singularity(const MechanismOf<F>& mechanism, const std::vector<BodyState<F>>& state,
                                      const S& t) {
    if constexpr (!std::same_as<typename F::Chart, NoChart>)
      for (int b = 0; b < mechanism.nb(); ++b) {
        const S distance = F::chart_distance(state[b].chart, state[b].q);
        if (distance < S(reframing_distance))
          return fmt::format(
              "body \"{}\" at t = {}: the coordinates of {} are at a distance of {:.1e} from their "
              "singularity; leave re-framing on, or start in another chart (for Euler angles: another "
              "sequence)",
              mechanism.body_names[b], static_cast<double>(t), F::name, static_cast<double>(distance));
      }
    return {};
  }

 private:
  ChartOptions options_;
  int changes_ = 0;
};

}  // namespace trivium
