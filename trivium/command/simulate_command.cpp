/// trivium simulate: a scene's motion in one formulation by one method.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <optional>

#include "base/command_line.hpp"
#include "base/exit_code.hpp"
#include "base/json_writer.hpp"
#include "base/number_text.hpp"
#include "base/progress.hpp"
#include "base/standard_output.hpp"
#include "base/table.hpp"
#include "formulations/side_by_side.hpp"
#include "integrators/methods.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/motion_csv.hpp"
#include "simulation/simulate.hpp"
#include "trivium/command/commands.hpp"
#include "trivium/command/motion_plot.hpp"
#include "trivium/command/scene_argument.hpp"

namespace trivium {

namespace {

struct SimulateArguments : SceneArguments {
  SimulationOptions options;
  std::string sequence = "313", out, plot;
  std::vector<double> baumgarte;
  bool raw_chart = false, no_projection = false, full_newton = false, json = false;
};

/// Set by the first Ctrl-C (or SIGTERM), which ends the run after the step at hand; one two seconds later or
/// more ends the program. Those between are taken for the same one, sent to a process and to its group.
volatile std::sig_atomic_t interrupted = 0;
volatile std::time_t interrupted_at = 0;
extern "C" void interrupt(int signal) {
  const std::time_t now = std::time(nullptr);
  if (interrupted == 0) {
    interrupted_at = now;
    interrupted = 1;
  } else if (now > interrupted_at + 1) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}
constexpr int exit_interrupted = 130;
constexpr int outputs_of_a_figure = 500;

bool has_own_lambda(const SimulationOptions& options) {
  return integrators::find_method(options.integrator)->has_own_lambda;
}

/// What leaves the run: the file, the figure, and a bar that says how far it is.
class Watcher : public SimulationObserver {
 public:
  Watcher(const SimulateArguments& arguments, const Mechanism<double>& mechanism)
      : arguments_(arguments), progress_("simulating", most_ticks) {
    if (!arguments.out.empty()) csv_.emplace(mechanism, has_own_lambda(arguments.options), arguments.out);
    if (!arguments.plot.empty())
      plot_.emplace(mechanism, fmt::format("{}: {}, {}", mechanism.name, arguments.options.formulation,
                                           arguments.options.integrator));
  }

  void sample(const MotionSample& sample) override {
    if (csv_) csv_->add(sample);
    if (plot_) plot_->add(sample);
    last_ = sample.state.t;
  }
  bool step(double t) override {
    const SimulationOptions& o = arguments_.options;
    for (const double done = (t - arguments_.t) / (o.end - arguments_.t) * most_ticks;
         static_cast<double>(ticks_) < done; ++ticks_)
      progress_.step();
    return interrupted == 0;
  }
  /// Writes what it has; says what it could not. Returns whether it could.
  bool keep() {
    try {
      if (csv_) csv_->keep();
      if (plot_) plot_->write(arguments_.plot);
      return true;
    } catch (const std::runtime_error& error) {
      complain(error.what());
      return false;
    }
  }
  /// The last state that it has; none where the motion did not begin.
  const std::optional<double>& last() const { return last_; }

 private:
  static constexpr int most_ticks = 1000;
  const SimulateArguments& arguments_;
  Progress progress_;
  int ticks_ = 0;
  std::optional<double> last_;
  std::optional<MotionCsv> csv_;
  std::optional<MotionPlot> plot_;
};

/// More than a thousandth of what moves, and than rounding of the energies.
bool balance_is_large(const SimulationReport& report) {
  const double energies =
      std::max({std::abs(report.energy_start), std::abs(report.energy_end), std::abs(report.work)});
  return !(report.unaccounted_energy <= 1e-3 * report.largest_kinetic + 1e-12 * energies);
}

std::vector<std::string> warnings_of(const SimulationReport& report) {
  std::vector<std::string> out;
  if (!report.passages.empty()) {
    out.push_back(
        fmt::format("the motion passed {}, the first near t = {:.6g}: rows that depend on others there were "
                    "left out, and it "
                    "went on as its velocities had it",
                    counted(report.passages.size(), "singular position", "singular positions"),
                    report.passages.front().t));
  }
  if (balance_is_large(report))
    out.push_back(fmt::format(
        "{:.1e} J are not accounted for, beside {:.1e} J of kinetic energy: the motion is not accurate; take "
        "tighter tolerances or smaller steps{}{}",
        report.unaccounted_energy, report.largest_kinetic, report.near_singular_chart.empty() ? "" : "; ",
        report.near_singular_chart));
  // index 3 leaves velocities off by its own error
  const auto drifts = [](double left) { return left > 1e-6; };
  if (drifts(report.phi) || (!report.is_implicit && drifts(report.phi_dot)))
    out.push_back(fmt::format("constraints are violated by up to {:.1e} (positions) and {:.1e} (velocities)",
                              report.phi, report.phi_dot));
  return out;
}

/// An object that begins with what was asked for.
JsonWriter json_of_run(const SimulateArguments& arguments, const Mechanism<double>& mechanism) {
  const SimulationOptions& o = arguments.options;
  JsonWriter json;
  json.begin_object()
      .text("scene", mechanism.name)
      .text("formulation", o.formulation)
      .text("integrator", o.integrator)
      .number("t_start", arguments.t)
      .number("t_end", o.end);
  return json;
}

std::string json_of(const SimulateArguments& arguments, const Mechanism<double>& mechanism,
                    const SimulationReport& r) {
  const SimulationOptions& o = arguments.options;
  JsonWriter json = json_of_run(arguments, mechanism);
  json.number("reached", r.reached).flag("complete", r.complete);
  if (o.step)
    json.number("step", *o.step);
  else
    json.number("rtol", o.tolerances.rtol).number("atol", o.tolerances.atol);
  const integrators::MethodParameters& p = o.parameters;
  if (p.order) json.number("order", *p.order);
  if (p.rho) json.number("rho", *p.rho);
  if (p.alpha) json.number("alpha", *p.alpha);
  if (r.is_implicit) json.flag("full_newton", p.full_newton.value_or(false));
  json.flag("projection", r.is_projected);
  if (o.baumgarte)
    json.begin_object("baumgarte")
        .number("alpha", o.baumgarte->alpha)
        .number("beta", o.baumgarte->beta)
        .end_object();
  json.number("steps", r.counters.steps)
      .number("rejected_steps", r.counters.rejected_steps)
      .number("right_sides", r.counters.right_sides)
      .number("newton_iterations", r.counters.iterations)
      .number("jacobians", r.jacobians)
      .number("factorisations", r.factorisations)
      .number("projection_changes", r.projection.changes)
      .number("restarts", r.counters.restarts)
      .number("reframings", r.reframings);
  json.begin_object("drift")
      .number("phi", r.phi)
      .number("phi_dot", r.phi_dot)
      .number("phi_before_projection", r.projection.position)
      .number("phi_dot_before_projection", r.projection.velocity)
      .number("normalisation", r.normalisation);
  if (r.has_own_lambda) json.number("raw_lambda", r.lambda_gap);
  json.end_object();
  json.begin_object("energy").number("start", r.energy_start).number("end", r.energy_end);
  if (r.does_work) json.number("work", r.work);
  json.number("unaccounted", r.unaccounted_energy).end_object();
  json.begin_array("singular_positions");
  for (const SingularPassage& passage : r.passages)
    json.begin_object().number("t", passage.t).number("rows", passage.rows).end_object();
  json.end_array();
  json.begin_array("impulses");
  for (const Impulse<double>& impulse : r.impulses)
    json.begin_object().number("t", impulse.t).numbers("lambda", impulse.lambda).end_object();
  json.end_array();
  json.texts("rows", mechanism.row_names).texts("warnings", warnings_of(r)).end_object();
  return json.str();
}

std::string json_of_failure(const SimulateArguments& arguments, const Mechanism<double>& mechanism,
                            const std::optional<double>& last, const char* error) {
  JsonWriter json = json_of_run(arguments, mechanism);
  json.flag("complete", false);
  if (last) json.number("last_output", *last);
  return json.text("error", error).end_object().str();
}

std::string text_of(const SimulateArguments& arguments, const Mechanism<double>& mechanism,
                    const SimulationReport& r) {
  const SimulationOptions& o = arguments.options;
  const std::string steps = o.step ? fmt::format("steps of {} s", *o.step)
                                   : fmt::format("rtol {}, atol {}", o.tolerances.rtol, o.tolerances.atol);
  std::string out = fmt::format("{}: t = {} to {}, {}\n\n", mechanism.name, arguments.t, r.reached, steps);
  Table table({"", fmt::format("{}, {}", o.formulation, o.integrator)});
  const auto add = [&](const std::string& name, const std::string& value) { table.add({name, value}); };
  add("steps", fmt::format("{}", r.counters.steps));
  add("rejected steps", fmt::format("{}", r.counters.rejected_steps));
  add("right sides", fmt::format("{}", r.counters.right_sides));
  if (r.counters.iterations > 0) add("Newton iterations", fmt::format("{}", r.counters.iterations));
  if (r.jacobians > 0) add("Jacobians (Newton's matrices)", fmt::format("{}", r.jacobians));
  add("factorisations", fmt::format("{}", r.factorisations));
  if (r.is_projected) add("changes by projection", fmt::format("{}", r.projection.changes));
  add("restarts", fmt::format("{}", r.counters.restarts));
  if (r.reframings > 0) add("re-framed bodies", fmt::format("{}", r.reframings));
  add("largest violation of positions [m, rad]", fmt::format("{:.1e}", r.phi));
  add("of velocities [m/s, rad/s]", fmt::format("{:.1e}", r.phi_dot));
  if (r.is_projected) {
    add("of positions before projection", fmt::format("{:.1e}", r.projection.position));
    add("of velocities before projection", fmt::format("{:.1e}", r.projection.velocity));
  }
  if (r.has_own_lambda) add("largest |raw lambda - lambda of (q, v)|", fmt::format("{:.1e}", r.lambda_gap));
  if (r.normalisation > 0) add("of p . p = 1", fmt::format("{:.1e}", r.normalisation));
  add("energy at the start [J]", fmt::format("{:.12g}", r.energy_start));
  add("energy at the end [J]", fmt::format("{:.12g}", r.energy_end));
  if (r.does_work) add("work done on it [J]", fmt::format("{:.12g}", r.work));
  add(r.does_work ? "largest change not accounted for [J]" : "largest change of energy [J]",
      fmt::format("{:.1e}", r.unaccounted_energy));
  out += table.text();
  for (const Impulse<double>& impulse : r.impulses) {
    out += fmt::format(
        "\nvelocities jumped with a driver at t = {}: impulses [N s or N m s, over the row's scale]\n",
        impulse.t);
    Table rows({"row", "impulse"});
    for (std::size_t k = 0; k < mechanism.row_names.size(); ++k)
      rows.add({mechanism.row_names[k], fmt::format("{:.9g}", impulse.lambda[static_cast<Eigen::Index>(k)])});
    out += rows.text();
  }
  return out;
}

int run_simulate(const SimulateArguments& given) {
  SimulateArguments arguments = given;
  SimulationOptions& options = arguments.options;
  options.charts = {*parse_euler_sequence(arguments.sequence), !arguments.raw_chart};
  if (arguments.full_newton) options.parameters.full_newton = true;
  options.projects = !arguments.no_projection && arguments.baumgarte.empty();
  if (!arguments.plot.empty() && !options.output_step && options.end > arguments.t)
    options.output_step = (options.end - arguments.t) / outputs_of_a_figure;
  if (!arguments.baumgarte.empty()) options.baumgarte = {arguments.baumgarte[0], arguments.baumgarte[1]};
  const scenes::Scene scene = load_state(arguments);
  const auto model = make_model<double>(scene, arguments.t);
  if (!report_consistency(arguments, consistency_of(model))) return exit_input_error;
  const Mechanism<double>& mechanism = model.mechanism;
  Watcher watcher(arguments, mechanism);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, interrupt);
  const auto say_what_is_kept = [&] {
    if (arguments.out.empty()) return;
    fmt::print(stderr, "{} holds {}\n", arguments.out,
               watcher.last() ? fmt::format("the motion until t = {}", *watcher.last())
                              : std::string("no state: the motion did not begin"));
  };
  try {
    const SimulationReport report = simulate(model, options, watcher);
    for (const std::string& warning : warnings_of(report)) fmt::print(stderr, "warning: {}\n", warning);
    fmt::print(
        "{}", arguments.json ? json_of(arguments, mechanism, report) : text_of(arguments, mechanism, report));
    const bool is_kept = watcher.keep();
    if (report.complete) return is_kept ? exit_done : exit_output_lost;
    fmt::print(stderr, "interrupted at t = {}\n", report.reached);
    if (is_kept) say_what_is_kept();
    return exit_interrupted;
  } catch (const integrators::UsageError& error) {
    complain(error.what());
    return exit_input_error;
  } catch (const std::runtime_error& error) {
    // of the model or of the method; what was computed until then is kept
    complain(name_source(arguments.scene, error.what()));
    if (arguments.json) fmt::print("{}", json_of_failure(arguments, mechanism, watcher.last(), error.what()));
    if (watcher.keep()) say_what_is_kept();
    return exit_solver_failed;
  }
}

/// Accepts a figure's file, where there is a program to draw it.
OptionCheck figure_file() {
  return {[](const std::string& text) {
            if (!text.ends_with(".svg"))
              return fmt::format("found {}; accepted: a file name ending in .svg", text);
            if (std::string why = why_not_writable(text); !why.empty()) return why;
            return std::system("command -v gnuplot >/dev/null 2>&1") == 0
                       ? std::string()
                       : std::string("gnuplot, which draws it, is not installed (Debian: gnuplot-nox)");
          },
          "FILE.svg"};
}

}  // namespace

Command add_simulate_command(ProgramOptions& program) {
  auto arguments = std::make_shared<SimulateArguments>();
  SimulationOptions& run = arguments->options;
  ProgramOptions options = program.add_subcommand(
      "simulate", "A scene's motion in one formulation by one method, its reactions and lambda");
  add_scene_options(options, *arguments);
  options.add_option("--formulation", &run.formulation, "Which formulation")
      .one_of(formulation_names())
      .show_default();
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
                  fmt::format("Time between outputs [s] (default: start and end; with --plot {} of them)",
                              outputs_of_a_figure))
      .check(positive_number());
  options.add_option("--out", &arguments->out, "Write the motion to this CSV file").check(writable_file());
  options.add_option("--plot", &arguments->plot, "Draw the outputs to this SVG file").check(figure_file());
  const ProgramOption no_projection = options.add_flag("--no-projection", &arguments->no_projection,
                                                       "Leave drift off the constraints as it is");
  options
      .add_option("--baumgarte", &arguments->baumgarte,
                  "Phi'' + 2 alpha Phi' + beta^2 Phi = 0 instead of projection [1/s]")
      .values({"ALPHA", "BETA"})
      .check(number_from_zero())
      .excludes(no_projection);
  options.add_option(
      "--order", &run.parameters.order,
      "Of bdf, 1 to 5 (default 2); of arkode-erk, 2 to 8, and arkode-dirk, 2 to 5 (default 5)");
  options.add_option("--rho", &run.parameters.rho,
                     "Of generalized-alpha: spectral radius at infinity, 0 to 1 (default 0.8)");
  options.add_option("--alpha", &run.parameters.alpha, "Of hht, -1/3 to 0 (default -0.2)");
  options.add_flag("--full-newton", &arguments->full_newton,
                   "Of implicit methods: a matrix every iteration, not every step");
  options.add_option("--sequence", &arguments->sequence, "Euler-angle sequence of r-epsilon")
      .one_of({euler_sequence_names.begin(), euler_sequence_names.end()})
      .show_default();
  options.add_flag("--no-reframe", &arguments->raw_chart,
                   "Take the raw chart of the sequence, and fail where it is singular");
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options,
          [arguments] { return naming_scene(*arguments, [&] { return run_simulate(*arguments); }); }};
}

}  // namespace trivium
