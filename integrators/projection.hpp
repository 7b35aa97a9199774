#pragma once
/// Back onto the constraints after a step: positions by Gauss-Newton to rounding, then velocities, both by
/// the least change in the model's own metric. One factorisation serves both as a rule.

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "integrators/system.hpp"

namespace trivium::integrators {

/// What projections found and left: the largest violations, and how many changes they made.
template <class S>
struct ProjectionReport {
  S position{0}, velocity{0};
  S position_left{0}, velocity_left{0};
  long changes = 0;
};

/// Moves y onto the constraints. Throws an IntegrationError that names the row which cannot be met.
template <FirstOrderSystem System>
class Projection {
 public:
  using S = typename System::Scalar;

  void operator()(System& system, const S& t, Flat<S>& y, ProjectionReport<S>& report) {
    is_factored_ = false;
    system.meet_internal(y);
    S found = system.position_violation(t, y);
    S left = approach(
        system, t, "position", found, S(system.length()), report.changes,
        [&] { return S(system.position_violation(t, y)); },
        [&](bool factor) { system.correct_positions(y, factor); });
    report.position = std::max(report.position, found);
    report.position_left = std::max(report.position_left, left);
    system.meet_internal(y);
    found = system.velocity_violation(t, y);
    left = approach(
        system, t, "velocity", found, S(system.speed()), report.changes,
        [&] { return S(system.velocity_violation(t, y)); },
        [&](bool factor) { system.correct_velocities(y, factor); });
    report.velocity = std::max(report.velocity, found);
    report.velocity_left = std::max(report.velocity_left, left);
  }

 private:
  /// Until the violation is rounding or falls no more. Beside a singular position rows that are nearly
  /// dependent are left alone, so that more than rounding may be left for a while; but never much.
  template <class Measure, class Correct>
  S approach(System& system, const S& t, const char* what, S violation, const S& scale, long& changes,
             const Measure& measure, const Correct& correct) {
    const S rounding = S(8 * std::numeric_limits<S>::epsilon()) * scale;
    constexpr int most_changes = 30;
    for (int k = 0; k < most_changes && violation > rounding; ++k) {
      const bool factors = !is_factored_;
      correct(factors);
      is_factored_ = true;
      ++changes;
      const S now = measure();
      const bool falls = now <= violation / 2;
      violation = now;
      if (falls) continue;
      if (factors) break;
      is_factored_ = false;  // the matrix of before is too far from that of here
    }
    if (!(violation <= S(1e-6) * scale))
      throw IntegrationError(fmt::format(
          "row \"{}\" at t = {}: the step left its {} too far off to project back; take smaller steps or "
          "tighter tolerances",
          system.worst_row(), static_cast<double>(t), what));
    return violation;
  }

  bool is_factored_ = false;
};

}  // namespace trivium::integrators
