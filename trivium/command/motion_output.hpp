#pragma once
/// What a run of `trivium simulate` writes while it goes on: the CSV file, the figure, and a bar that says
/// how far it is. Decides that an interrupt ends the run. The summary behind it is motion_report.hpp's.

#include <optional>
#include <string>

#include "base/progress.hpp"
#include "mechanism/mechanism.hpp"
#include "simulation/motion.hpp"
#include "simulation/motion_csv.hpp"
#include "simulation/simulate.hpp"
#include "trivium/command/motion_plot.hpp"

namespace trivium {

class MotionOutput : public SimulationObserver {
 public:
  /// `csv` and `figure`: the files; empty for none.
  MotionOutput(const Mechanism<double>& mechanism, double t_start, const SimulationOptions& options,
               const std::string& csv, const std::string& figure);

  bool sample(const MotionSample& sample) override;
  bool step(double t) override;

  /// Writes what it has; says on stderr what it could not. Returns whether it could.
  bool keep();
  /// Says on stderr until when the CSV file has the motion.
  void say_what_is_kept() const;
  /// The last state that it has; none where the motion did not begin.
  const std::optional<double>& last() const { return last_; }

 private:
  static constexpr int most_ticks = 1000;

  double t_start_, t_end_;
  std::string csv_file_, figure_file_;
  Progress progress_;
  int ticks_ = 0;
  std::optional<double> last_;
  std::optional<MotionCsv> csv_;
  std::optional<MotionPlot> plot_;
};

}  // namespace trivium
