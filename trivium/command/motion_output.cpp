/// Passes every output of a run to the CSV file and to the figure, every step to the progress bar. Files are
/// put in place after the run, by `keep`.

#include "trivium/command/motion_output.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

#include "base/standard_output.hpp"
#include "integrators/methods.hpp"
#include "trivium/command/interrupt.hpp"

namespace trivium {

MotionOutput::MotionOutput(const Mechanism<double>& mechanism, double t_start,
                           const SimulationOptions& options, const std::string& csv,
                           const std::string& figure)
    : t_start_(t_start),
      t_end_(options.end),
      csv_file_(csv),
      figure_file_(figure),
      progress_("simulating", most_ticks) {
  if (!csv.empty())
    csv_.emplace(mechanism, integrators::find_method(options.integrator)->has_raw_lambda, csv);
  if (!figure.empty())
    plot_.emplace(mechanism,
                  fmt::format("{}: {}, {}", mechanism.name, options.formulation, options.integrator));
}

bool MotionOutput::sample(const MotionSample& sample) {
  last_ = sample.state.t;
  if (plot_) plot_->add(sample);
  return !csv_ || csv_->add(sample);  // a run whose results cannot be written ends
}

bool MotionOutput::step(double t) {
  for (const double done = (t - t_start_) / (t_end_ - t_start_) * most_ticks;
       static_cast<double>(ticks_) < done; ++ticks_)
    progress_.step();
  return !is_interrupted();
}

bool MotionOutput::keep() {
  try {
    if (csv_) csv_->keep();
    if (plot_) plot_->write(figure_file_);
    return true;
  } catch (const std::runtime_error& error) {
    complain(error.what());
    return false;
  }
}

void MotionOutput::say_what_is_kept() const {
  if (csv_file_.empty()) return;
  fmt::print(stderr, "{} holds {}\n", csv_file_,
             last_ ? fmt::format("the motion until t = {}", *last_)
                   : std::string("no state: the motion did not begin"));
}

}  // namespace trivium
