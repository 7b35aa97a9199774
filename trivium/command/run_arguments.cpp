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
  options.add_option("--integrator", &run.integrator, "Which method")
      .one_of(integrators::method_names())
      .show_default();
  options.add_option("--t-end", &run.end, "The end of the run [s]").check(finite_time()).show_default();
  const ProgramOption step =
      options.add_option("--step", &run.step, "Steps of this length [s] instead of tolerances")
          .check(positive_number());
  options.add_option("--rtol", &run.tolerances.rtol, "Relative tolerance of a step")
      .check(positive_number())
      .excludes(step)
      .show_default();
  options.add_option("--atol", &run.tolerances.atol, "Absolute tolerance of a step")
      .check(positive_number())
      .excludes(step)
      .show_default();
  options
      .add_option("--output-step", &run.output_step,
                  fmt::format("Time between outputs [s] (default: {})", outputs))
      .check(positive_number());
  options.add_option(
      "--order", &run.parameters.order,
      "Of bdf, 1 to 5 (default 2); of arkode-erk, 2 to 8, and arkode-dirk, 2 to 5 (default 5)");
  options.add_option("--rho", &run.parameters.rho,
                     "Of generalized-alpha: spectral radius at infinity, 0 to 1 (default 0.8)");
  options.add_option("--alpha", &run.parameters.alpha, "Of hht, -1/3 to 0 (default -0.2)");
  options.add_flag("--full-newton", &arguments.full_newton,
                   "Of implicit methods: a matrix every iteration, not every step");
  options.add_option("--sequence", &arguments.sequence, "Euler-angle sequence of r-epsilon")
      .one_of({euler_sequence_names.begin(), euler_sequence_names.end()})
      .show_default();
  options.add_flag("--no-reframe", &arguments.raw_chart,
                   "Take the raw chart of the sequence, and fail where it is singular");
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
             : std::string("gnuplot, which draws it, is not installed (Debian: gnuplot-nox)");
}

}  // namespace trivium
