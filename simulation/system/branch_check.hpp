#pragma once
/// Decides whether the projection of a step may have left the branch of the motion. Constraints can be
/// satisfied on several branches: a four-bar, for example, closes in two ways.

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulation/system/constraint_violation.hpp"
#include "simulation/system/state_layout.hpp"

namespace trivium {

/// Compares the projection of a step with the step, beside which a correct projection is small. A projection
/// is rejected if, in some component (set of bodies connected by rows), it changes the state by more than a
/// tenth of the change made by the step plus a small share of the state itself. integrators/integrate.cpp
/// then rejects the step and asks the method for a shorter one.
template <Formulation F>
class BranchCheck {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  explicit BranchCheck(int nb) : way_(nb + 1) {}

  /// The arguments are y before the step, after the step, and after its projection.
  bool projection_is_too_large(const StateLayout<F>& layout, const ConstraintViolation<S>& components,
                               const StateVector& before, const StateVector& stepped,
                               const StateVector& projected) {
    const auto exceeds = [&](int first, int width, const S& little, bool is_velocity) {
      for (Way& way : way_) way = {};
      for (int b = 0; b < layout.nb(); ++b) {
        Way& way = way_[components.component_of(b)];
        const int at = first + width * b;
        way.back += (projected.segment(at, width) - stepped.segment(at, width)).squaredNorm();
        way.step += (stepped.segment(at, width) - before.segment(at, width)).squaredNorm();
        way.size += stepped.segment(at, width).squaredNorm();
        if (is_velocity) way.least = components.fastest_of(b) / 1000;
      }
      using std::sqrt;
      return std::any_of(way_.begin(), way_.end(), [&](const Way& way) {
        return !(sqrt(way.back) <= sqrt(way.step) / times_smaller + little * (sqrt(way.size) + way.least));
      });
    };
    return exceeds(0, layout.positions, S(little_position), false) ||
           exceeds(layout.position_size(), layout.velocities, S(little_velocity), true);
  }

 private:
  /// A trusted projection is at least this many times smaller than the step that it corrects. 10 is chosen by
  /// experiment: a smaller number accepts projections onto another branch, a larger one rejects correct
  /// steps.
  static constexpr int times_smaller = 10;
  /// Relative changes of a component that a projection may always make. Velocities are allowed more, because
  /// the velocities of two branches differ by as much as their own size. Both values are chosen by
  /// experiment.
  static constexpr double little_position = 1e-4, little_velocity = 1e-2;

  /// Sums of squares over a component: change by the projection, change by the step, and values of the state.
  /// The velocities of a component at rest are rounding errors and give no scale: the scale is at least
  /// `least`, a thousandth of the component's fastest speed so far. The factor is chosen by experiment.
  struct Way {
    S back{0}, step{0}, size{0}, least{0};
  };
  std::vector<Way> way_;
};

}  // namespace trivium
