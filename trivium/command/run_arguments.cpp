/// Declares the options that `simulate` and `compare` share, with their help texts, checks and defaults.

#include "trivium/command/run_arguments.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "bodies/rotations/euler_sequence.hpp"
#include "integrators/methods.hpp"
#include "trivium/choices.hpp"

namespace trivium {

SimulationOptions RunArguments::run_options() const {
  SimulationOptions run = options;
  run.charts = chart_options(sequence, !raw_chart);
  if (full_newton) run.parameters.full_newton = true;
  return run;
}

void add_run_options(ProgramOptions& options, RunArguments& arguments, const std::string& outputs) {
  SimulationOptions& run = arguments.options;
  options.add_option("--integrator", &run.integrator, "Integration method")
      .one_of(integrators::method_names())
      .show_default();
  options.add_option("--t-end", &run.end, "End of the run [s]").check(finite_time()).show_default();
  const ProgramOption step =
      options.add_option("--step", &run.step, "Constant step size [s] instead of tolerances")
          .check(positive_number());
  options.add_option("--rtol", &run.tolerances.rtol, "Relative tolerance for the error of a step")
      .check(positive_number())
      .excludes(step)
      .show_default();
  options.add_option("--atol", &run.tolerances.atol, "Absolute tolerance for the error of a step")
      .check(positive_number())
      .excludes(step)
      .show_default();
  options
      .add_option("--max-step", &run.max_step,
                  "Longest step [s] with tolerances, so that no short pulse is missed")
      .check(positive_number())
      .excludes(step);
  options
      .add_option("--output-step", &run.output_step,
                  fmt::format("Time between outputs [s] (default: {})", outputs))
      .check(positive_number());
  options.add_option(
      "--order", &run.parameters.order,
      "Order: 1 to 5 for bdf (default 2), 2 to 6 or 8 for arkode-erk, 2 to 5 for arkode-dirk (default 5)");
  options.add_option(
      "--rho", &run.parameters.rho,
      "Spectral radius of generalized-alpha and generalized-alpha-gl2 at infinite frequency, 0 to 1 (default "
      "0.8; generalized-alpha with tolerances: at most 0.95)");
  options.add_option("--alpha", &run.parameters.alpha,
                     "Parameter alpha of hht, -1/3 to 0 (default -0.2; with tolerances at most -0.05)");
  options.add_flag(
      "--full-newton", &arguments.full_newton,
      "Implicit methods except those of SUNDIALS: a new Newton matrix in every iteration, instead of "
      "about one per step");
  options.add_option("--sequence", &arguments.sequence, "Euler-angle sequence of r-epsilon")
      .one_of({euler_sequence_names.begin(), euler_sequence_names.end()})
      .show_default();
  options.add_flag("--no-reframe", &arguments.raw_chart,
                   "Keep the chart of the Euler-angle sequence; the run fails where the chart is singular");
}

OptionCheck figure_file() {
  return {[](const std::string& text) {
            if (!text.ends_with(".svg"))
              return fmt::format("found {}; accepted: a file name ending in .svg", text);
            if (std::string why = why_not_writable(text); !why.empty()) return why;
            return why_no_figures();
          },
          "FILE.svg"};
}

std::string why_no_figures() {
  return std::system("command -v gnuplot >/dev/null 2>&1") == 0
             ? std::string()
             : std::string("gnuplot, which draws the figure, is not installed (Debian: gnuplot-nox)");
}

}  // namespace trivium
