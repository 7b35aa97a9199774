#pragma once
/// Changes of chart (re-framing) along a motion, and the removal of full turns from angles that grow with
/// every turn. Formulations without charts (NoChart) do nothing here.

#include <fmt/format.h>

#include <concepts>
#include <numbers>
#include <vector>

#include "formulations/euler_chart_choice.hpp"
#include "simulation/system/state_layout.hpp"

namespace trivium {

/// Angles with more turns than this lose them: the body gets coordinates afresh. The last digit of an angle
/// of 100 turns is 1e-13 rad. It moves points of the body by so much per metre, which iterations onto the
/// constraints still take for rounding.
inline constexpr double most_turns = 100;

/// Gives a body whose Euler angles come nearer to their singularity than reframing_distance another chart,
/// chosen as at the start (formulations/euler_chart_choice.hpp), in which its orientation and rates in y are
/// rewritten. If the user keeps the charts, near_singular_chart names such a body.
template <Formulation F>
class ChartSwitching {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  explicit ChartSwitching(const ChartOptions& options) : options_(options) {}

  /// The number of changes of chart so far.
  int changes() const { return changes_; }

  /// Changes the charts of bodies that are near their singularity, unless the user keeps the charts, and
  /// removes full turns; in `state`, which must be the state of y, and in y. Returns whether any coordinates
  /// of y changed. Throws a ModelError that names the body if no chart is far enough from its singularity.
  bool change(const MechanismOf<F>& mechanism, const S& t, const StateLayout<F>& layout,
              std::vector<BodyState<F>>& state, StateVector& y) {
    if constexpr (std::same_as<typename F::Chart, NoChart>) return false;
    bool changed = false;
    for (int b = 0; b < layout.nb(); ++b) {
      BodyState<F>& body = state[b];
      const bool is_near =
          options_.reframe && (F::chart_distance(body.chart, body.q) < S(reframing_distance));
      const S angle = layout.orientation(y, b).template lpNorm<Eigen::Infinity>();
      const bool is_wound = angle > S(most_turns * 2 * std::numbers::pi);
      if (!is_near && !is_wound) continue;
      const Vector4<S> p = F::to_euler_parameters(body.chart, body.q);
      const Vector3<S> omega_bar = kinematics_of(body).omega_bar;
      try {
        if (is_near) body.chart = F::choose_chart(options_, p);
      } catch (const ModelError& error) {
        throw ModelError({fmt::format("body \"{}\"", mechanism.body_names[b]), static_cast<double>(t)},
                         error);
      }
      body.q = F::from_pose(body.chart, p, omega_bar);
      layout.place(y, b).tail(F::orientation_size) = F::orientation_of(body.chart, p);
      layout.rate(y, b).tail(F::rotational_unknowns) = F::velocity_of(body.chart, body.q);
      changed = true;
      if (is_near) ++changes_;
    }
    return changed;
  }

 private:
  ChartOptions options_;
  int changes_ = 0;
};

}  // namespace trivium
