#pragma once
/// The output of `trivium simulate` during a run: the CSV file, the figure and a progress bar. An interrupt
/// ends the run here. motion_report.hpp prints the summary after the run.

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
  /// `csv` and `figure` are file names; an empty name means no file.
  MotionOutput(const Mechanism<double>& mechanism, double t_start, const SimulationOptions& options,
               const std::string& csv, const std::string& figure);

  bool sample(const MotionSample& sample) override;
  bool step(double t) override;

  /// Writes the CSV file and the figure. If that fails, prints an error on stderr and returns false.
  bool keep();
  /// Prints on stderr up to which time the CSV file holds the motion.
  void say_what_is_kept() const;
  /// The time of the last output [s]; none if the run failed before its first output.
  const std::optional<double>& last() const { return last_; }

 private:
  /// resolution of the progress bar
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
