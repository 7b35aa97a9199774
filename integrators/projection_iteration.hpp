#pragma once
/// The iteration that leads a state back onto the constraints: Newton corrections of the positions until
/// their violation is rounding, then of the velocities. A single correction is the system's
/// (correct_positions, correct_velocities): the least change in its own metric. One factorisation serves both
/// as a rule.
///
/// Here is decided when a projection has converged, when a matrix is made anew, and when a row cannot be met.
/// Whether a projection went too far is asked by integrate.hpp.

#include <fmt/format.h>

#include <limits>

#include "integrators/contract/errors.hpp"
#include "integrators/contract/first_order_system.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/projection_report.hpp"

namespace trivium::integrators {

/// Moves y onto the constraints, and returns the row whose velocity was the last to be met. Throws an
/// IntegrationError that names the row which cannot be met.
template <FirstOrderSystem System>
class ProjectionIteration {
 public:
  using S = typename System::Scalar;

  int operator()(System& system, const S& t, StateVector<S>& y, ProjectionReport<S>& report) {
    is_factored_ = false;
    system.normalise(y);
    approach(
        system, t, "position", report.position, report.position_left, report.changes,
        [&] { return system.position_violation(t, y); },
        [&](bool factor) { system.correct_positions(t, y, factor); });
    system.normalise(y);
    return approach(
        system, t, "velocity", report.velocity, report.velocity_left, report.changes,
        [&] { return system.velocity_violation(t, y); },
        [&](bool factor) { system.correct_velocities(t, y, factor); });
  }

 private:
  /// Until the violation is rounding or falls no more. Beside a singular position rows that are nearly
  /// dependent are left alone, so that more than rounding may be left for a while; but never much.
  template <class Measure, class Correct>
  int approach(System& system, const S& t, const char* what, S& found, S& left, long& changes,
               const Measure& measure, const Correct& correct) {
    Violation<S> off = measure();
    raise(found, off.size);
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
      is_factored_ = false;  // the matrix of before is too far from that of here
    }
    raise(left, off.size);
    if (!(off.relative <= S(1e-6)))
      throw IntegrationError(
          {fmt::format("row \"{}\"", system.row_name(off.row)), static_cast<double>(t)},
          fmt::format("the step left its {} too far off to project back; take smaller steps or tighter "
                      "tolerances",
                      what));
    return off.row;
  }

  bool is_factored_ = false;
};

}  // namespace trivium::integrators
