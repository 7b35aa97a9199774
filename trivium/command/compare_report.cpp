/// Prints the comparison of a motion in several formulations. The verdict names the output at which the ratio
/// of difference and bound is the largest.

#include "trivium/command/compare_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/csv.hpp"
#include "base/gnuplot.hpp"
#include "base/number_text.hpp"
#include "base/table.hpp"
#include "simulation/neighbouring_start.hpp"

namespace trivium {

namespace {

std::string brief(double x) { return fmt::format("{:.1e}", x); }

/// The verdict on an output: holds, exceeds a bound, or the reason why it is not judged.
std::string note_of(const MotionComparison& comparison, const ComparedInstant& now) {
  if (now.is_singular) return "singular";
  const bool is_judged = comparison.is_judged(now);
  if (is_judged && !(now.lambda <= now.lambda_bound)) return "EXCEEDS along the motion";
  if (now.one_state && !now.one_state->holds()) return "EXCEEDS at one state";
  return is_judged ? "holds" : "parted";
}

/// The instant with the largest ratio of difference and bound; null if no instant has a ratio.
template <class Ratio>
const ComparedInstant* worst_of(const MotionComparison& comparison, const Ratio& ratio) {
  const ComparedInstant* worst = nullptr;
  for (const ComparedInstant& now : comparison.instants) {
    if (!ratio(now)) continue;
    if (!worst || !(*ratio(now) <= *ratio(*worst))) worst = &now;
  }
  return worst;
}

}  // namespace

std::string CompareReport::verdict_along() const {
  const MotionComparison& c = comparison;
  if (!c.has_unique_lambda) return "none: no multiplier is unique";
  const ComparedInstant* worst = worst_of(c, [&](const ComparedInstant& now) -> std::optional<double> {
    if (!c.is_judged(now)) return {};
    return now.lambda / now.lambda_bound;
  });
  if (!worst) return "not judged";
  return fmt::format("{}; difference {}, bound {} at t = {:.6g}", c.holds_along() ? "holds" : "EXCEEDS",
                     brief(worst->lambda), brief(worst->lambda_bound), worst->t);
}

std::string CompareReport::verdict_at_states() const {
  const MotionComparison& c = comparison;
  const ComparedInstant* worst = worst_of(c, [](const ComparedInstant& now) -> std::optional<double> {
    if (!now.one_state || now.is_singular) return {};
    return std::max(now.one_state->lambda, now.one_state->is_constrained ? now.one_state->acceleration : 0) /
           now.one_state->bound;
  });
  if (!worst)
    return std::any_of(c.instants.begin(), c.instants.end(), [](const auto& now) { return now.one_state; })
               ? "not judged: all compared states are near singular positions"
               : "not judged: the scene is too large for the dense solver, which computes kappa";
  const char* verdict = c.holds_at_states() ? "holds" : "EXCEEDS";
  if (!c.has_unique_lambda)
    return worst->one_state->is_constrained
               ? fmt::format("none: no multiplier is unique; accelerations: {}", verdict)
               : std::string("none: there are no constraints");
  const auto& at = *worst->one_state;
  const bool by_acceleration = at.is_constrained && at.acceleration > at.lambda;
  return fmt::format("{}; difference{} {}, bound {} at t = {:.6g}", verdict,
                     by_acceleration ? " of accelerations" : "",
                     brief(by_acceleration ? at.acceleration : at.lambda), brief(at.bound), worst->t);
}

std::string CompareReport::runs_table() const {
  Table table({"formulation", "steps", "rejected steps", "evaluations", "factorisations", "CPU [s]",
               "chart changes", "charts"});
  for (const ComparedRun& run : comparison.runs) {
    const SimulationReport& r = run.report;
    if (!run.error.empty()) {
      table.add({run.formulation, "failed", "", "", "", "", "", ""});
      continue;
    }
    table.add({run.formulation, std::to_string(r.counters.steps), std::to_string(r.counters.rejected_steps),
               std::to_string(r.counters.right_sides), std::to_string(r.factorisations),
               fmt::format("{:.3f}", r.seconds), std::to_string(r.reframings),
               run.charts.empty() ? "-" : fmt::format("{}", fmt::join(run.charts, ", "))});
  }
  return table.text();
}

std::string CompareReport::instants_table() const {
  Table table({"t [s]", "lambda", "bound", "amplification", "position [m]", "rotation [rad]",
               "lambda at state", "bound at state", "accelerations at state", "kappa", "verdict"});
  for (const ComparedInstant& now : comparison.instants) {
    const auto& at = now.one_state;
    const bool is_shown = at.has_value() || &now == &comparison.instants.back();
    if (!is_shown) continue;
    // zeros would look like agreement where no multiplier is unique
    const auto of_lambda = [&](double x) { return comparison.has_unique_lambda ? brief(x) : "none"; };
    table.add({fmt::format("{:.6g}", now.t), of_lambda(now.lambda), of_lambda(now.lambda_bound),
               of_lambda(now.amplification), brief(now.position), brief(now.rotation),
               at ? of_lambda(at->lambda) : "-", at ? brief(at->bound) : "-",
               at ? brief(at->acceleration) : "-", at ? brief(at->kappa) : "-", note_of(comparison, now)});
  }
  return table.text();
}

std::string CompareReport::text() const {
  const std::string steps =
      options.step ? fmt::format("steps of {} s", *options.step)
                   : fmt::format("rtol {}, atol {}", options.tolerances.rtol, options.tolerances.atol);
  std::string out =
      fmt::format("{}: t = {} to {} by {}, {}; {}, {}\n\n", mechanism.name, t_start, options.end,
                  options.integrator, steps, counted(comparison.runs.size(), "formulation", "formulations"),
                  counted(comparison.instants.size(), "output", "outputs"));
  out += runs_table();
  if (comparison.instants.empty()) return out;
  out += "\nlargest differences between formulations (lambda and accelerations are relative)\n" +
         instants_table();
  if (comparison.neighbour_distance > 0)
    out += fmt::format(
        "\namplification: relative change of lambda by neighbouring starts, divided by the relative "
        "distance {} of the starts\nbound: number of steps * tolerance * amplification\n",
        brief(comparison.neighbour_distance));
  else if (options.step)
    out +=
        "\nbound: twice the change by halving the step, summed over the two formulations that change most\n";
  else
    out += "\nbound: number of steps * tolerance; the constraints admit no neighbouring start\n";
  if (comparison.judged_until)
    out += fmt::format(
        "from t = {:.6g} on, {} exceeds {} (verdict \"parted\"): lambda along the motion is not judged\n",
        *comparison.judged_until,
        options.step ? "twice the change of lambda by halving the step"
                     : "the difference of neighbouring motions or the bound",
        small_difference);
  if (const auto singular = std::count_if(comparison.instants.begin(), comparison.instants.end(),
                                          [](const ComparedInstant& now) { return now.is_singular; });
      singular > 0)
    out += fmt::format("not judged: {} at a singular position, where lambda is not unique\n",
                       counted(static_cast<std::size_t>(singular), "output", "outputs"));
  out += fmt::format("lambda along the motion: {}\nlambda at one state: {}\n", verdict_along(),
                     verdict_at_states());
  return out;
}

std::string CompareReport::json() const {
  const MotionComparison& c = comparison;
  JsonWriter json;
  json.begin_object()
      .text("scene", mechanism.name)
      .text("integrator", options.integrator)
      .number("t_start", t_start)
      .number("t_end", options.end);
  if (options.step)
    json.number("step", *options.step);
  else
    json.number("rtol", options.tolerances.rtol).number("atol", options.tolerances.atol);
  json.begin_array("runs");
  for (const ComparedRun& run : c.runs) {
    const SimulationReport& r = run.report;
    json.begin_object().text("formulation", run.formulation);
    if (!run.error.empty()) {
      json.text("error", run.error).end_object();
      continue;
    }
    json.number("steps", r.counters.steps)
        .number("rejected_steps", r.counters.rejected_steps)
        .number("right_sides", r.counters.right_sides)
        .number("newton_iterations", r.counters.iterations)
        .number("factorisations", r.factorisations)
        .number("reframings", r.reframings)
        .number("seconds", r.seconds)
        .texts("charts", run.charts)
        .end_object();
  }
  json.end_array().begin_array("outputs");
  for (const ComparedInstant& now : c.instants) {
    json.begin_object()
        .number("t", now.t)
        .number("lambda", now.lambda)
        .number("lambda_bound", now.lambda_bound)
        .number("amplification", now.amplification)
        .number("position", now.position)
        .number("rotation", now.rotation)
        .text("verdict", note_of(comparison, now));
    if (now.one_state)
      json.number("state_lambda", now.one_state->lambda)
          .number("state_bound", now.one_state->bound)
          .number("state_acceleration", now.one_state->acceleration)
          .number("condition", now.one_state->kappa);
    json.end_object();
  }
  json.end_array().number("neighbour_distance", c.neighbour_distance);
  if (c.judged_until) json.number("judged_until", *c.judged_until);
  return json.flag("has_unique_lambda", c.has_unique_lambda)
      .flag("holds_along", c.holds_along())
      .flag("holds_at_states", c.holds_at_states())
      .end_object()
      .str();
}

std::string CompareReport::csv() const {
  std::string out = csv_line({"t", "lambda", "lambda_bound", "amplification", "position", "rotation",
                              "state_lambda", "state_bound", "state_acceleration", "condition", "verdict"});
  for (const ComparedInstant& now : comparison.instants) {
    std::vector<std::string> line;
    for (const double x :
         {now.t, now.lambda, now.lambda_bound, now.amplification, now.position, now.rotation})
      line.push_back(number_text(x));
    if (const auto& at = now.one_state)
      for (const double x : {at->lambda, at->bound, at->acceleration, at->kappa})
        line.push_back(number_text(x));
    else
      line.resize(line.size() + 4);
    line.push_back(note_of(comparison, now));
    out += csv_line(line);
  }
  return out;
}

void CompareReport::plot(const std::string& file) const {
  // 0 cannot be drawn on a logarithmic axis
  const auto seen = [](double x) { return x > 0 ? fmt::format("{:.3g}", x) : std::string("NaN"); };
  std::string along, states;
  for (const ComparedInstant& now : comparison.instants) {
    along += fmt::format("{:.9g} {} {} {} {}\n", now.t, seen(now.lambda), seen(now.lambda_bound),
                         seen(now.position), seen(now.rotation));
    if (const auto& at = now.one_state)
      states +=
          fmt::format("{:.9g} {} {} {}\n", now.t, seen(at->lambda), seen(at->bound), seen(at->acceleration));
  }
  const std::string at_states =
      states.empty() ? "set multiplot next\n"
                     : "set ylabel 'at one state, relative'\n"
                       "plot $states using 1:2 with linespoints lw 1.5 lc 1 title 'lambda', "
                       "$states using 1:3 with lines lw 1.5 dt 2 lc 1 title '100 u kappa', "
                       "$states using 1:4 with linespoints lw 1.5 lc 3 title 'accelerations'\n";
  run_gnuplot(
      fmt::format(
          "$along << EOD\n{}EOD\n$states << EOD\n{}EOD\n"
          "set terminal svg size 900,1000 noenhanced font 'sans,12' background '#ffffff'\nset output {}\n"
          "set multiplot layout 3,1 title {}\nset grid\nset lmargin 12\nset rmargin 26\n"
          "set key at screen 0.99, graph 1 right top\nset xlabel 't [s]'\nset logscale y\nset format y "
          "'%.0e'\n"
          "set ylabel 'along the motion, relative'\n"
          "plot $along using 1:2 with lines lw 1.5 lc 1 title 'lambda', "
          "$along using 1:3 with lines lw 1.5 dt 2 lc 1 title 'bound of lambda'\n{}"
          "set ylabel 'along the motion'\n"
          "plot $along using 1:4 with lines lw 1.5 lc 2 title 'positions [m]', "
          "$along using 1:5 with lines lw 1.5 lc 4 title 'rotations [rad]'\nunset multiplot\n",
          along, states.empty() ? "0 1 1 1\n" : states, gnuplot_quoted(file),
          gnuplot_quoted(fmt::format("{}: largest differences between {}, {}", mechanism.name,
                                     counted(comparison.runs.size(), "formulation", "formulations"),
                                     options.integrator)),
          at_states),
      file);
}

}  // namespace trivium
