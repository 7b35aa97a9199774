#pragma once
/// The projection of a state onto the constraints: Newton corrections of the positions until their violation
/// is rounding, then the same for the velocities. The system computes a single correction (correct_positions,
/// correct_velocities), the smallest one in its metric. As a rule one factorisation serves positions and
/// velocities.
///
/// This file decides when a projection has converged, when a matrix is factored again, and when a row cannot
/// be satisfied. Whether a projection went too far is decided by the system, which integrate.cpp asks.

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "integrators/contract/errors.hpp"
#include "integrators/contract/first_order_system.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/projection_report.hpp"

namespace trivium::integrators {

/// Moves y onto the constraints. Returns the number of the row with the largest remaining violation of
/// velocities, relative to the numbers that the row is computed from. Throws an IntegrationError that names
/// the row if a row cannot be satisfied.
template <FirstOrderSystem System>
class ProjectionIteration {
 public:
  using S = typename System::Scalar;

  int operator()(System& system, const S& t, StateVector<S>& y, ProjectionReport<S>& report) {
    is_factored_ = false;
    system.normalise(y);
    std::optional<S> found;
    const S left = left_;
    approach(
        system, t, "position", report.position, report.position_left, report.changes,
        [&] {
          const Violation<S> off = system.position_violation(t, y);
          left_ = off.relative;
          if (!found) found = left_;
          return off;
        },
        [&](bool factor) { system.correct_positions(t, y, factor); });
    drift_ = *found - 10 * left;
    system.normalise(y);
    return approach(
        system, t, "velocity", report.velocity, report.velocity_left, report.changes,
        [&] { return system.velocity_violation(t, y); },
        [&](bool factor) { system.correct_velocities(t, y, factor); });
  }

  /// The relative violation of positions that the last projection found, beyond ten times what the projection
  /// before it had left: dependent rows may differ from the others by a small amount that no projection
  /// removes.
  const S& drift() const { return drift_; }

 private:
  /// Corrects until the violation is rounding, or until a correction by a matrix that is factored at the
  /// current state no longer halves the violation. Near a singular position nearly dependent rows are left
  /// out of the corrections, so that a violation above rounding may remain for some steps, up to
  /// most_violation.
  template <class Measure, class Correct>
  int approach(System& system, const S& t, const char* what, S& found, S& left, long& changes,
               const Measure& measure, const Correct& correct) {
    Violation<S> off = measure();
    raise(found, off.size);
    // Newton's method needs about four corrections, a kept matrix a few more. 30 is a safety limit.
    constexpr int most_changes = 30;
    for (int k = 0; k < most_changes && off.relative > rounding<S>(); ++k) {
      const bool factors = !is_factored_;
      correct(factors);
      is_factored_ = true;
      ++changes;
      const S before = off.relative;
      off = measure();
      const bool falls = off.relative <= before / 2;
      if (falls) continue;
      if (factors) break;
      is_factored_ = false;  // the matrix of an earlier state is too far from the one at this state
    }
    raise(left, off.size);
    if (!(off.relative <= S(most_violation)))
      throw IntegrationError({fmt::format("row \"{}\"", system.row_name(off.row)), static_cast<double>(t)},
                             fmt::format("the {} violation after this step is too large for the projection "
                                         "to converge; take smaller steps or tighter tolerances",
                                         what));
    return off.row;
  }

  bool is_factored_ = false;
  S drift_{0}, left_{0};
};

}  // namespace trivium::integrators
