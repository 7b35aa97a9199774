/// Does every method converge with its published order, in every formulation? The errors of positions,
/// velocities, lambda (of the state) and of the method's own lambda at outputs of a run, in quad (as far as a
/// method computes so) that no rounding hides them, at steps that halve.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include "base/gnuplot.hpp"
#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "bodies/numbers/quad.hpp"
#include "formulations/side_by_side.hpp"
#include "integrators/methods.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/simulate.hpp"
#include "validation/harness/program.hpp"

namespace trivium {

namespace {

/// Observed and published orders may differ by this.
constexpr double tolerance = 0.2;
/// The floor of errors in double (see Case).
constexpr double floor_in_double = 1e-14;

struct Case {
  std::string label, method;
  integrators::MethodParameters parameters;
  int order, raw_order;  ///< of the method's own lambda; 0: it has none
  int steps;             ///< of the coarsest run
  /// Where the mass matrix depends on the position the order falls, to between 1 and what it is elsewhere.
  bool needs_constant_mass = false;
  bool is_double = false;  ///< of a library that computes in double alone: errors stay above its rounding
  /// Where it is measured unless scenes are named: on the slider-crank some errors first fall faster.
  std::string scene = "spatial_slider_crank";
  /// An error tells an order where it is above this share of what it is an error of: in quad, starts differ
  /// as projections of a scene's doubles do.
  double floor = 1e-16;
};

std::vector<Case> cases() {
  std::vector<Case> all{{"dopri5", "dopri5", {}, 5, 0, 20},
                        {"rkf78", "rkf78", {}, 8, 0, 4},
                        {"abm", "abm", {}, 5, 0, 160},
                        {"hedop5", "hedop5", {}, 5, 4, 80, false, false, "double_pendulum"},
                        {"hem4", "hem4", {}, 4, 2, 20},
                        {"generalized-alpha", "generalized-alpha", {}, 2, 2, 100},
                        {"generalized-alpha-gl2", "generalized-alpha-gl2", {}, 2, 2, 50},
                        {"hht", "hht", {.alpha = -0.2}, 2, 2, 200, true},
                        {"hht, alpha = 0", "hht", {.alpha = 0.0}, 2, 0, 50},
                        {"radau5", "radau5", {}, 5, 3, 20},
                        // starts differ less on the slider-crank, and two errors above 1e-16 are too few
                        {"radau9", "radau9", {}, 9, 5, 6, false, false, "spatial_slider_crank", 5e-18},
                        {"rattle", "rattle", {}, 2, 2, 50},
                        {"rattle4", "rattle4", {}, 4, 2, 20}};
  for (int k = 1; k <= 5; ++k)
    all.push_back({fmt::format("bdf{}", k), "bdf", {.order = k}, k, k, k < 3 ? 400 : 100});
  // 8 comes down to rounding before its slope shows
  for (const auto& [k, steps] : {std::pair(2, 200), {3, 50}, {4, 20}, {5, 6}, {6, 6}})
    all.push_back({fmt::format("arkode-erk, {}", k), "arkode-erk", {.order = k}, k, 0, steps, false, true});
  for (const auto& [k, steps] : {std::pair(2, 200), {3, 50}, {4, 20}, {5, 10}})
    all.push_back({fmt::format("arkode-dirk, {}", k), "arkode-dirk", {.order = k}, k, 0, steps, false, true});
  return all;
}

constexpr std::array<const char*, 4> quantities{"r", "v", "lambda", "raw lambda"};
using Errors = std::array<double, 4>;

/// Of one case in one formulation.
struct Row {
  std::string scene, formulation, error;
  Case of;
  std::vector<double> h;
  std::vector<Errors> errors;
  Errors floor{};  ///< what rounding leaves of errors

  bool solved() const { return error.empty(); }
  bool has(int quantity) const { return quantity < 3 || of.raw_order > 0; }
  double observed(int quantity, std::size_t level) const {
    return std::log2(errors[level - 1][quantity] / errors[level][quantity]);
  }
  /// The finest level that shows an order; 0 where none does.
  std::size_t level(int quantity) const {
    std::size_t k = h.size() - 1;
    while (k > 0 && !(errors[k][quantity] > floor[quantity])) --k;
    return k;
  }
  bool is_rounding(int quantity) const { return level(quantity) == 0; }
  double observed(int quantity) const { return observed(quantity, level(quantity)); }
  /// Whether the formulation's mass matrix lets the order fall.
  bool may_fall() const { return of.needs_constant_mass && !inertia_is_constant(formulation); }
  int published(int quantity) const { return quantity == 3 ? of.raw_order : of.order; }
  std::string expected(int quantity) const {
    return may_fall() ? fmt::format("1..{}", published(quantity)) : std::to_string(published(quantity));
  }
  bool passed(int quantity) const {
    if (is_rounding(quantity)) return true;
    const double found = observed(quantity), p = published(quantity);
    if (!may_fall()) return std::abs(found - p) <= tolerance;
    // of r the part of order 1 is small, and may first cancel that of order 2; but errors do not grow
    return found <= p + tolerance && found >= (quantity == 0 ? 0 : 1) - tolerance;
  }
  bool passed() const {
    if (!solved()) return false;
    for (int k = 0; k < 4; ++k)
      if (has(k) && !passed(k)) return false;
    return true;
  }
};

Errors floors_of(const std::vector<MotionSample>& exact, double share) {
  Errors size{};
  for (const MotionSample& sample : exact) {
    for (const Pose<double>& pose : sample.state.pose) size[0] = std::max({size[0], pose.r.norm(), 1.0});
    for (const Twist<double>& twist : sample.state.twist)
      size[1] = std::max({size[1], twist.r_dot.norm(), twist.omega_bar.norm()});
    size[2] = size[3] = std::max(size[2], sample.lambda.norm());
  }
  for (double& x : size) x *= share;
  return size;
}

/// At the middle and at the end: where an error happens to pass zero at the one it does not at the other.
std::vector<MotionSample> outputs_of(const scenes::Scene& scene, SimulationOptions options,
                                     bool is_double = false) {
  options.output_step = options.end / 2;
  Samples samples;
  is_double ? simulate(make_model<double>(scene), options, samples)
            : simulate(make_model<Quad>(scene), options, samples);
  samples.all.erase(samples.all.begin());
  return samples.all;
}

/// The largest of the outputs, with what doubles leave of each.
Errors errors_of(const std::vector<MotionSample>& found, const std::vector<MotionSample>& exact) {
  Errors e{};
  const auto raise = [&](int quantity, double error) { e[quantity] = std::max(e[quantity], error); };
  const auto rest = [](const MotionSample& sample, const auto& part) {
    return sample.state_rest ? part(*sample.state_rest) : decltype(part(*sample.state_rest))::Zero().eval();
  };
  for (std::size_t k = 0; k < exact.size(); ++k) {
    // p and -p are one orientation
    const auto apart = [&](const auto& part, double sign = 1) {
      return ((part(found[k].state) - sign * part(exact[k].state)) +
              (rest(found[k], part) - sign * rest(exact[k], part)))
          .norm();
    };
    for (std::size_t b = 0; b < exact[k].state.pose.size(); ++b) {
      const auto p = [&](const MechanismState<double>& s) { return Vector4<double>(s.pose[b].p); };
      raise(0, apart([&](const MechanismState<double>& s) { return Vector3<double>(s.pose[b].r); }));
      raise(0, 2 * std::min(apart(p), apart(p, -1)));
      raise(1, apart([&](const MechanismState<double>& s) { return Vector3<double>(s.twist[b].r_dot); }));
      raise(1, apart([&](const MechanismState<double>& s) { return Vector3<double>(s.twist[b].omega_bar); }));
    }
    const auto off = [&](const VectorX<double>& lambda, const VectorX<double>& lambda_rest) {
      VectorX<double> difference = lambda - exact[k].lambda;
      if (lambda_rest.size() > 0) difference += lambda_rest;
      return (difference - exact[k].lambda_rest).norm();
    };
    raise(2, off(found[k].lambda, found[k].lambda_rest));
    if (found[k].raw_lambda.size() > 0) raise(3, off(found[k].raw_lambda, found[k].raw_lambda_rest));
  }
  return e;
}

Row measure(const NamedScene& named, const std::string& formulation, const Case& of, double t_end, int levels,
            const std::vector<MotionSample>& exact) {
  Row row{named.scene.name,
          formulation,
          "",
          of,
          {},
          {},
          floors_of(exact, of.is_double ? floor_in_double : of.floor)};
  try {
    SimulationOptions options;
    options.formulation = formulation;
    options.integrator = of.method;
    options.parameters = of.parameters;
    options.end = t_end;
    for (int level = 0; level < levels; ++level) {
      row.h.push_back(t_end / (of.steps << level));
      options.step = row.h.back();
      row.errors.push_back(errors_of(outputs_of(named.scene, options, of.is_double), exact));
    }
  } catch (const std::runtime_error& error) {
    row.error = name_source(named.source, error.what());
  }
  return row;
}

/// Says which methods have no order to observe.
std::string not_here() {
  std::vector<std::string_view> names;
  for (const integrators::MethodInfo& method : integrators::methods())
    if (!method.takes_given_steps) names.push_back(method.name);
  return fmt::format(
      "{} choose steps and orders by their tolerances, and have no order to observe: work_precision shows\n"
      "their errors.\n",
      fmt::join(names, ", "));
}

std::vector<std::string> columns() {
  return {"scene", "formulation", "method", "quantity", "h", "error", "order", "published", "verdict"};
}

std::string text(const std::vector<Row>& rows) {
  std::string out;
  ErrorLines errors;
  for (std::size_t first = 0; first < rows.size();) {
    Table table({"method", "formulation", "published", "r", "v", "lambda", "raw lambda", "verdict"});
    const std::string& scene = rows[first].scene;
    for (; first < rows.size() && rows[first].scene == scene; ++first) {
      const Row& row = rows[first];
      std::vector<std::string> line{row.of.label, row.formulation, row.expected(0)};
      for (int k = 0; k < 4; ++k)
        line.push_back(!row.solved() || !row.has(k) ? "-"
                       : row.is_rounding(k)
                           ? fmt::format("rounding ({:.0e})", row.errors.back()[k])
                           : fmt::format("{:.2f} ({:.0e})", row.observed(k), row.errors[row.level(k)][k]));
      line.push_back(!row.solved() ? "ERROR" : row.passed() ? "ok" : "DIFFERS");
      table.add(line);
      if (!row.solved()) errors.add(row.error, row.formulation + ", " + row.of.label);
    }
    out += fmt::format(
        "{}: observed orders, and in brackets the error at the finest step that is above rounding\n\n{}\n",
        scene, table.text());
  }
  if (std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.may_fall(); }))
    out +=
        "1..2: hht weighs forces at both ends of a step, but M at one. Where M depends on positions it is "
        "of\n"
        "order 1; in r that part is small, and may first cancel that of order 2.\n\n";
  return out + errors.text() + not_here();
}

std::string json(const std::vector<Row>& rows, bool passed) {
  JsonWriter out;
  out.begin_object().flag("passed", passed).begin_array("orders");
  for (const Row& row : rows) {
    out.begin_object()
        .text("scene", row.scene)
        .text("formulation", row.formulation)
        .text("method", row.of.label);
    if (row.solved())
      for (int k = 0; k < 4; ++k)
        if (row.has(k) && !row.is_rounding(k)) out.number(quantities[k], row.observed(k));
    out.number("published", row.of.order).flag("passed", row.passed());
    if (!row.solved()) out.text("error", row.error);
    out.end_object();
  }
  return out.end_array().end_object().str();
}

/// Errors over steps, a panel a quantity and a line a method, of one scene in one formulation; with triangles
/// of the slopes.
void plot(const std::vector<Row>& rows, const std::string& scene, const std::string& formulation,
          const std::string& file) {
  std::string data;
  std::array<std::vector<std::string>, 4> curves;
  std::array<std::map<int, std::array<double, 2>>, 4> lowest;  // by order: where its lowest line begins
  for (const Row& row : rows) {
    if (row.scene != scene || row.formulation != formulation || !row.solved()) continue;
    const std::size_t n = curves[0].size() + 1;
    data += fmt::format("$m{} << EOD\n", n);
    for (std::size_t level = 0; level < row.h.size(); ++level)
      data += fmt::format("{:.9g} {:.3e}\n", row.h[level], fmt::join(row.errors[level], " "));
    data += "EOD\n";
    for (int k = 0; k < 4; ++k) {
      curves[k].push_back(row.has(k)
                              ? fmt::format("$m{} using 1:{} with linespoints lw 1.5 pt 7 ps 0.6 lc {} dt {} "
                                            "title {}",
                                            n, k + 2, n % 8 + 1, n / 8 + 1, gnuplot_quoted(row.of.label))
                              : "");
      if (!row.has(k)) continue;
      auto& low = lowest[k]
                      .try_emplace(row.published(k), std::array{row.h.back(), row.errors.back()[k]})
                      .first->second;
      if (row.errors.back()[k] < low[1]) low = {row.h.back(), row.errors.back()[k]};
    }
  }
  std::string panels;
  for (int k = 0; k < 4; ++k) {
    std::erase(curves[k], "");
    panels += "unset object\nunset label\n";
    int n = 0;
    for (const auto& [order, from] : lowest[k]) {
      // below the line: one step to the right, and up by the order
      const double h = from[0], wide = 1.7 * h, low = from[1] / 4, high = low * std::pow(1.7, order);
      panels += fmt::format(
          "set object {0} polygon from {1:.5g},{2:.5g} to {3:.5g},{2:.5g} to {3:.5g},{4:.5g} to "
          "{1:.5g},{2:.5g} "
          "fillstyle empty border lc 'gray40'\nset label {0} '{5}' at {6:.5g},{7:.5g} textcolor 'gray40'\n",
          ++n, h, low, wide, high, order, 1.05 * wide, std::sqrt(low * high));
    }
    panels +=
        fmt::format("set ylabel {}\nplot {}\n", gnuplot_quoted(std::string("error of ") + quantities[k]),
                    fmt::join(curves[k], ", \\\n  "));
  }
  run_gnuplot(fmt::format(
      "{}set terminal svg size 1500,1000 noenhanced font 'sans,11' background '#ffffff'\nset output {}\n"
      "set multiplot layout 2,2 title {}\nset grid\nset logscale xy\nset format '%.0e'\nset xlabel 'h [s]'\n"
      "set key outside right top font ',9'\n{}unset multiplot\n",
      data, gnuplot_quoted(file), gnuplot_quoted(fmt::format("{}, {}", scene, formulation)), panels));
}

struct Options {
  double t_end = 0.1;
  int levels = 3;
  std::string plot, plotted = "r-omega";
  std::vector<std::string> methods;
};

int run(const Program& program, const Options& options) {
  std::vector<Case> chosen = cases();
  if (!options.methods.empty())
    std::erase_if(chosen, [&](const Case& c) {
      return std::find(options.methods.begin(), options.methods.end(), c.method) == options.methods.end();
    });
  if (chosen.empty()) {
    fmt::print(stderr, "error: {}", not_here());
    return exit_input_error;
  }
  std::vector<NamedScene> scenes = program.scenes(0);
  if (!program.names_scenes())
    std::erase_if(scenes, [&](const NamedScene& s) {
      return std::ranges::count(chosen, s.scene.name, &Case::scene) == 0;
    });
  std::vector<Row> rows;
  Progress progress("convergence_order", scenes.size() * formulation_names().size() * chosen.size());
  bool solved = true, passed = true;
  for (const NamedScene& named : scenes) {
    SimulationOptions reference;
    reference.integrator = "rkf78";
    reference.end = options.t_end;
    reference.tolerances = {1e-19, 1e-21};
    std::vector<MotionSample> exact;
    std::string error;
    try {
      exact = outputs_of(named.scene, reference);
    } catch (const std::runtime_error& of_reference) {
      error = name_source(named.source, fmt::format("no reference: {}", of_reference.what()));
    }
    for (const Case& of : chosen)
      for (const std::string& formulation : formulation_names()) {
        progress.step();
        if (of.method.starts_with("rattle") && !inertia_is_constant(formulation)) continue;
        if (!program.names_scenes() && of.scene != named.scene.name) continue;
        rows.push_back(error.empty() ? measure(named, formulation, of, options.t_end, options.levels, exact)
                                     : Row{named.scene.name, formulation, error, of, {}, {}, {}});
        solved = solved && rows.back().solved();
        passed = passed && rows.back().passed();
      }
  }
  ResultsFile file("convergence_order", columns());
  for (const Row& row : rows)
    for (int k = 0; k < 4; ++k)
      for (std::size_t level = 0; row.solved() && row.has(k) && level < row.h.size(); ++level)
        file.add({row.scene, row.formulation, row.of.label, quantities[k], results_number(row.h[level]),
                  results_number(row.errors[level][k]),
                  level > 0 && level <= row.level(k) ? results_number(row.observed(k, level)) : "none",
                  row.expected(k),
                  level + 1 < row.h.size() ? "none"
                  : row.passed(k)          ? "ok"
                                           : "DIFFERS"});
  program.write(file);
  if (!options.plot.empty() && !rows.empty()) plot(rows, rows.front().scene, options.plotted, options.plot);
  fmt::print("{}", program.json() ? json(rows, passed) : text(rows));
  return batch_exit(solved, passed);
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  Program program("Does every method converge with its published order, in every formulation?",
                  "convergence_order", "spatial_slider_crank, and double_pendulum for hedop5");
  Options options;
  program.options().add_option("--t-end", options.t_end, "The end of the runs [s]")->capture_default_str();
  program.options()
      .add_option("--levels", options.levels, "How many steps, each half of the one before")
      ->check(CLI::Range(2, 8))
      ->capture_default_str();
  program.options()
      .add_option("--method", options.methods, "These methods alone")
      ->check(CLI::IsMember(integrators::method_names()));
  program.options().add_option("--plot", options.plot, "Draw errors over steps to this SVG file");
  program.options()
      .add_option("--plotted", options.plotted, "The formulation that is drawn")
      ->check(CLI::IsMember(formulation_names()))
      ->capture_default_str();
  return program.run(argc, argv, [&] { return run(program, options); });
}
