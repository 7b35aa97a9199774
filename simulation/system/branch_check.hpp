#pragma once
/// Decides whether the projection of a step would leave the branch of the motion. Constraints may be met on
/// several branches, as a four-bar's two ways of closing. A projection is a small correction of a step, so
/// one that moves some component (bodies that rows connect) by more than a tenth of what the step did, and
/// by more than a share of its own numbers, is not trusted. integrators/integrate.cpp then
/// takes the step back and has the method take a shorter one.

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulation/system/constraint_violation.hpp"
#include "simulation/system/state_layout.hpp"

namespace trivium {

template <Formulation F>
class BranchCheck {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  explicit BranchCheck(int nb) : way_(nb + 1) {}

  /// Of y before the step, after the step, and after the projection.
  bool projection_is_too_large(const StateLayout<F>& layout, const ConstraintViolation<S>& components,
                               const StateVector& before, const StateVector& stepped,
                               const StateVector& projected) {
    const auto exceeds = [&](int first, int width, const S& little) {
      for (Way& way : way_) way = {};
      for (int b = 0; b < layout.nb(); ++b) {
        Way& way = way_[components.component_of(b)];
        const int at = first + width * b;
        way.back += (projected.segment(at, width) - stepped.segment(at, width)).squaredNorm();
        way.step += (stepped.segment(at, width) - before.segment(at, width)).squaredNorm();
        way.size += stepped.segment(at, width).squaredNorm();
      }
      using std::sqrt;
      return std::any_of(way_.begin(), way_.end(), [&](const Way& way) {
        return !(sqrt(way.back) <= sqrt(way.step) / times_smaller + little * sqrt(way.size));
      });
    };
    return exceeds(0, layout.positions, S(little_position)) ||
           exceeds(layout.position_size(), layout.velocities, S(little_velocity));
  }

 private:
  /// A projection is to be so many times smaller than the step that it corrects.
  static constexpr int times_smaller = 10;
  /// Shares of a component's numbers that a projection may always move. Velocities may move more: another
  /// branch of velocities is as far as they are large.
  static constexpr double little_position = 1e-4, little_velocity = 1e-2;

  /// Of a component, squares: how far a projection, a step moved its numbers, and how large they are.
  struct Way {
    S back{0}, step{0}, size{0};
  };
  std::vector<Way> way_;
};

}  // namespace trivium
