/// Decides from the report of a run which warnings it deserves. The thresholds are here and in
/// simulation/system/energy_account.hpp.

#include "simulation/motion_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number_text.hpp"
#include "simulation/system/energy_account.hpp"

namespace trivium {

namespace {

bool loses_energy(const SimulationReport& report) {
  const double energies =
      std::max({std::abs(report.energy_start), std::abs(report.energy_end), std::abs(report.work),
                report.fastest_energy});  // the scale of rounding where all energies are 0
  return energy_is_lost(report.unaccounted_energy, report.largest_kinetic, energies);
}

}  // namespace

std::vector<MotionWarning> motion_warnings(const SimulationReport& report) {
  std::vector<MotionWarning> out;
  const auto warn = [&](const std::string& text, double error = 0) {
    out.emplace_back().text = text;
    out.back().relative_error = error;
  };
  // a row that counts by mistake, or does not, makes another mechanism
  for (const std::string& row : report.narrow_rows)
    warn(row + "; if the mechanism is meant otherwise, the relative error of its motion is 1", 1);
  if (!report.passages.empty())
    warn(
        fmt::format("steps ended near {}, the first near t = {:.6g}: dependent rows were left out there, "
                    "and the motion continued in the direction of its velocities",
                    counted(report.passages.size(), "singular position", "singular positions"),
                    report.passages.front().t));
  // A thousandth of the size or of the speed shows in a drawing. It separates the motions of the catalogue at
  // usual steps from those of fast tops at the same steps.
  constexpr double visible = 1e-3;
  constexpr long few_steps = 10;  // a run of so few has too few for an estimate
  const std::optional<LocalErrorSums>& errors = report.local_errors;
  constexpr double most_unknown = 0.1;  // the others stand for so many
  if (errors && errors->unknown > most_unknown && report.counters.steps > few_steps)
    warn(
        fmt::format("the local errors of {:.0f} % of the steps are not known, which lie alone between two "
                    "events or cannot be halved; take smaller steps, or check with --verify",
                    100 * errors->unknown));
  if (errors && !(errors->relative() <= visible))
    warn(fmt::format(
             "body \"{}\": the local errors of the steps add up to {:.1e} m in a motion of {:.1e} m, and "
             "to {:.1e} m/s at speeds up to {:.1e} m/s: it may not be accurate, even if its energy is "
             "conserved; take smaller steps, or check with --verify",
             report.errs_most, errors->position, errors->size, errors->velocity, errors->speed),
         errors->relative());
  if (loses_energy(report))
    warn(fmt::format("the energy error is {:.1e} J, the largest kinetic energy {:.1e} J: the motion is not "
                     "accurate; take tighter tolerances or smaller steps{}{}",
                     report.unaccounted_energy, report.largest_kinetic,
                     report.near_singular_chart.empty() ? "" : "; ", report.near_singular_chart),
         report.unaccounted_energy / report.largest_kinetic);
  // Implicit methods on index 3 do not enforce the velocity rows: their violation is the error of the method.
  // 1e-6 is chosen by experiment: projections leave far less, and a drift of this size begins to show in the
  // results.
  constexpr double warn_above = 1e-6;  // [m, rad, m/s, rad/s]
  const auto drifts = [](double left) { return left > warn_above; };
  if (drifts(report.phi) || (!report.is_implicit && drifts(report.phi_dot)))
    warn(
        fmt::format("constraints are violated by up to {:.1e} (positions) and {:.1e} (velocities); take "
                    "smaller steps or tighter tolerances, and project each step",
                    report.phi, report.phi_dot));
  return out;
}

std::vector<std::string> warnings_of(const SimulationReport& report) {
  std::vector<std::string> out;
  for (MotionWarning& warning : motion_warnings(report)) out.push_back(std::move(warning.text));
  return out;
}

}  // namespace trivium
