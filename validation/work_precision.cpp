/// What does accuracy cost in time? The same motions by every method in every formulation, and by Simbody's
/// own integrators, from loose to tight: errors against one reference, and CPU seconds, taken apart from them
/// and in turn. Ratios count, seconds are this machine's.

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "base/gnuplot.hpp"
#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "scenes/generators.hpp"
#include "validation/harness/program.hpp"
#include "validation/precision/runs.hpp"

namespace trivium::precision {

namespace {

/// Errors of positions [m] that the costs are told for.
constexpr std::array targets{1e-3, 1e-6, 1e-9, 1e-10};
/// The lengths of the catalogue's runs [s]; 1 elsewhere. That of the four-bars ends before they lie flat.
const std::map<std::string, double> lengths{
    {"two_bars", 10}, {"a01_pendulum", 10},    {"n_four_bar_2", 0.6},  {"andrews_squeezer", 0.05},
    {"bricard", 5},   {"flyball_governor", 1}, {"stewart_platform", 2}};

struct Options {
  bool quick = false;
  int repetitions = 5;
  std::string plots;
};

struct Contest {
  std::string scene;
  double t_end, reference_error;
  bool is_trusted;
  std::vector<Outcome> outcomes;
};

std::vector<TimedMotion> motions(const Program& program) {
  std::vector<std::string> names = program.names();
  if (names.empty())
    names = {"two_bars", "a01_pendulum",     "n_four_bar_2",    "andrews_squeezer",
             "bricard",  "flyball_governor", "stewart_platform"};
  std::vector<TimedMotion> all;
  for (const std::string& name : names) {
    scenes::Scene scene =
        name == "two_bars" ? scenes::two_bars() : load_consistent_scenes({name}, 0).front().scene;
    const auto known = lengths.find(scene.name);
    all.push_back({std::move(scene), known == lengths.end() ? 1 : known->second});
  }
  return all;
}

std::string who(const Entry& e) {
  return e.formulation.empty() ? fmt::format("{} {}", e.engine, e.method)
                               : fmt::format("{}, {}", e.method, e.formulation);
}
bool is_peer(const Entry& e) { return e.formulation.empty(); }

/// The cheapest of a contender's runs (or of all of ours, or all peers') that is as exact; null where none
/// is.
template <class Counts>
const Outcome* cheapest(const Contest& contest, double target, const Counts& counts) {
  const Outcome* best = nullptr;
  if (contest.reference_error > target / 10) return best;  // not known so well
  for (const Outcome& o : contest.outcomes)
    if (o.solved() && counts(o.entry) && o.errors.position <= target &&
        (best == nullptr || o.seconds.median < best->seconds.median))
      best = &o;
  return best;
}

std::string cost_table(const Contest& contest) {
  std::vector<std::string> header{"method"};
  for (const double target : targets) header.push_back(fmt::format("{:.0e} m", target));
  Table table(header);
  std::vector<std::string> contenders;
  for (const Outcome& o : contest.outcomes)
    if (std::find(contenders.begin(), contenders.end(), who(o.entry)) == contenders.end())
      contenders.push_back(who(o.entry));
  for (const std::string& contender : contenders) {
    std::vector<std::string> row{contender};
    for (const double target : targets) {
      const Outcome* best = cheapest(contest, target, [&](const Entry& e) { return who(e) == contender; });
      row.push_back(best ? fmt::format("{:.2f} ms ({})", 1e3 * best->seconds.median, best->entry.setting())
                         : "-");
    }
    table.add(row);
  }
  std::string out = fmt::format("{}, {} s: CPU time to reach an error of positions (reference: {}{})\n\n{}",
                                contest.scene, contest.t_end,
                                contest.reference_error > 0 ? fmt::format("{:.0e} m", contest.reference_error)
                                                            : "no difference in double",
                                contest.is_trusted ? ", trusted numbers among it" : "", table.text());
  for (const double target : targets) {
    const Outcome *ours = cheapest(contest, target, [](const Entry&e) { return !is_peer(e); }),
                  *peer = cheapest(contest, target, is_peer);
    if (ours && peer)
      out += fmt::format("{:.0e} m: Simbody's best ({}) takes {:.2f} x the time of our best ({})\n", target,
                         peer->entry.method, peer->seconds.median / ours->seconds.median, who(ours->entry));
  }
  for (const Outcome& o : contest.outcomes)
    if (!o.solved()) out += fmt::format("{}, {}: {}\n", who(o.entry), o.entry.setting(), o.failure);
  return out + "\n";
}

std::vector<std::string> columns() {
  return {"scene",       "t_end",          "reference_error", "engine",   "formulation", "method",
          "setting",     "position",       "orientation",     "velocity", "reaction",    "drift",
          "energy",      "least_ms",       "median_ms",       "low_ms",   "high_ms",     "steps",
          "evaluations", "factorisations", "failure"};
}

std::vector<std::string> fields(const Contest& contest, const Outcome& o) {
  const auto number = [&](double x) { return o.solved() ? results_number(x) : "none"; };
  const auto optional = [](const std::optional<double>& x) { return x ? results_number(*x) : "none"; };
  const auto word = [](const std::string& s) { return s.empty() ? std::string("none") : s; };
  return {contest.scene,
          results_number(contest.t_end),
          results_number(contest.reference_error),
          o.entry.engine,
          word(o.entry.formulation),
          o.entry.method,
          o.entry.setting(),
          number(o.errors.position),
          number(o.errors.orientation),
          number(o.errors.velocity),
          optional(o.errors.reaction),
          optional(o.errors.drift),
          optional(o.errors.energy),
          number(1e3 * o.seconds.least),
          number(1e3 * o.seconds.median),
          number(1e3 * o.seconds.low),
          number(1e3 * o.seconds.high),
          std::to_string(o.steps),
          std::to_string(o.evaluations),
          std::to_string(o.factorisations),
          word(o.failure)};
}

std::string json(const std::vector<Contest>& contests, const std::string& errors) {
  JsonWriter out;
  out.begin_object().begin_array("contests");
  for (const Contest& c : contests) {
    out.begin_object()
        .text("scene", c.scene)
        .number("t_end", c.t_end)
        .number("reference_error", c.reference_error)
        .flag("trusted_numbers", c.is_trusted);
    out.begin_array("runs");
    for (const Outcome& o : c.outcomes) {
      out.begin_object()
          .text("engine", o.entry.engine)
          .text("method", o.entry.method)
          .text("setting", o.entry.setting());
      if (!is_peer(o.entry)) out.text("formulation", o.entry.formulation);
      if (o.solved()) {
        out.number("position", o.errors.position)
            .number("orientation", o.errors.orientation)
            .number("velocity", o.errors.velocity);
        if (o.errors.reaction) out.number("reaction", *o.errors.reaction);
        if (o.errors.drift) out.number("drift", *o.errors.drift);
        if (o.errors.energy) out.number("energy", *o.errors.energy);
        out.number("steps", o.steps)
            .number("evaluations", o.evaluations)
            .number("factorisations", o.factorisations)
            .number("least_ms", 1e3 * o.seconds.least)
            .number("median_ms", 1e3 * o.seconds.median)
            .number("low_ms", 1e3 * o.seconds.low)
            .number("high_ms", 1e3 * o.seconds.high);
      } else {
        out.text("failure", o.failure);
      }
      out.end_object();
    }
    out.end_array().end_object();
  }
  out.end_array();
  if (!errors.empty()) out.text("error", errors);
  return out.end_object().str();
}

/// What one method's runs look like in a figure.
struct Curve {
  std::string name, points;
  bool is_peer;
  std::vector<std::string> failed_at;  ///< where runs that failed are marked, along the axis of errors

  Curve(const Contest& contest, const Entry& method)
      : name(who(method)), is_peer(precision::is_peer(method)) {
    for (const Outcome& o : contest.outcomes) {
      if (who(o.entry) != name) continue;
      if (!o.solved()) {
        failed_at.push_back(o.entry.rtol ? fmt::format("first {:.0e}", *o.entry.rtol) : "graph 0.98");
      } else if (o.errors.position > contest.reference_error) {
        points += fmt::format("{:.3e} {:.5g} {:.5g} {:.5g}\n", o.errors.position, o.seconds.median,
                              o.seconds.low, o.seconds.high);
      }
    }
  }
};

/// gnuplot's numbers.
struct LineStyle {
  int points, dashes;
};
constexpr std::array<LineStyle, 3> lines_of_ours{{{7, 1}, {9, 4}, {13, 3}}},
    lines_of_peers{{{4, 2}, {8, 5}, {6, 2}}};

/// Seconds over errors, a line a method: ours in r-omega and Simbody's. Runs that failed are crosses at the
/// bottom, at the tolerance or, of given steps, at the right; the legend counts them.
void plot(const Contest& contest, const std::filesystem::path& folder) {
  std::vector<Curve> curves;
  for (const Outcome& o : contest.outcomes) {
    const bool is_shown = is_peer(o.entry) || o.entry.formulation == "r-omega";
    const auto is_its = [&](const Curve& curve) { return curve.name == who(o.entry); };
    if (is_shown && std::none_of(curves.begin(), curves.end(), is_its)) curves.emplace_back(contest, o.entry);
  }
  std::string data, crosses;
  std::vector<std::string> lines;
  int rows_of_crosses = 0;
  std::size_t peers = 0;
  for (std::size_t n = 0; n < curves.size(); ++n) {
    const Curve& curve = curves[n];
    // eight colors; when they are used up, other lines and points
    const std::size_t among_its_kind = curve.is_peer ? peers++ : n - peers;
    const std::size_t color = among_its_kind % 8 + 1;
    const LineStyle style = (curve.is_peer ? lines_of_peers : lines_of_ours)[among_its_kind / 8 % 3];
    if (!curve.points.empty()) data += fmt::format("$m{} << EOD\n{}EOD\n", n, curve.points);
    // that none hides another's
    if (!curve.failed_at.empty()) ++rows_of_crosses;
    for (const std::string& at : curve.failed_at)
      crosses += fmt::format("set label '' at {}, graph {:.3f} point pt 2 ps 0.6 lc {}\n", at,
                             0.015 * rows_of_crosses, color);
    const std::string counted = curve.failed_at.empty()
                                    ? curve.name
                                    : fmt::format("{} ({} failed)", curve.name, curve.failed_at.size());
    lines.push_back(fmt::format("{} with yerrorlines lw 1.5 pt {} ps 0.5 lc {} dt {} title {}",
                                curve.points.empty() ? "keyentry" : fmt::format("$m{} using 1:2:3:4", n),
                                style.points, color, style.dashes, gnuplot_quoted(counted)));
  }
  for (const auto& [terminal, suffix] :
       {std::pair("svg size 900,650 noenhanced font 'sans,11' background '#ffffff'", ".svg"),
        {"pdfcairo size 16cm,11.5cm noenhanced font 'sans,9'", ".pdf"}})
    run_gnuplot(fmt::format(
        "{}{}set terminal {}\nset output {}\nset title {}\nset grid\nset logscale xy\nset format '%.0e'\n"
        "set xlabel 'error of positions [m]; crosses: runs that failed, at their tolerance'\n"
        "set ylabel 'CPU time [s]'\nset key outside right\nplot {}\n",
        data, crosses, terminal, gnuplot_quoted((folder / (contest.scene + suffix)).string()),
        gnuplot_quoted(fmt::format("{}, {} s", contest.scene, contest.t_end)), fmt::join(lines, ", \\\n  ")));
}

int run(const Program& program, const Options& options) {
  const std::vector<TimedMotion> all = motions(program);
  const std::vector<Entry> entered = entries(options.quick);
  Progress progress("work_precision",
                    all.size() * (entered.size() + static_cast<std::size_t>(options.repetitions)));
  if (!options.plots.empty()) std::filesystem::create_directories(options.plots);
  std::vector<Contest> contests;
  ErrorLines errors;
  for (const TimedMotion& motion : all) {
    std::optional<Reference> reference;
    try {
      reference = reference_of(motion);
    } catch (const std::runtime_error& error) {
      errors.add(name_source(motion.scene.name, error.what()), "the reference");
      continue;
    }
    contests.push_back({motion.scene.name, motion.t_end, reference->own_error, reference->is_trusted,
                        contest(motion, *reference, entered, options.repetitions, [&] { progress.step(); })});
    if (!program.json()) fmt::print("{}", cost_table(contests.back()));
    std::fflush(stdout);
    if (!options.plots.empty()) plot(contests.back(), options.plots);
  }
  if (!program.json())
    fmt::print(
        "{}Times are medians of {} repetitions; the CSV has their intervals, of confidence {:.2f}.\n"
        "A run of a second or more is timed once: its interval has no width.\n",
        errors.text(), options.repetitions, confidence(options.repetitions));
  ResultsFile file("work_precision", columns());
  for (const Contest& c : contests)
    for (const Outcome& o : c.outcomes) file.add(fields(c, o));
  program.write(file);
  if (program.json()) fmt::print("{}", json(contests, errors.text()));
  return batch_exit(contests.size() == all.size(), true);
}

}  // namespace

}  // namespace trivium::precision

int main(int argc, char** argv) {
  using namespace trivium;
  Program program("What does accuracy cost in time? SCENE may also be two_bars, a double pendulum in space.",
                  "work_precision", "two_bars, IFToMM A01 to A05 and the Stewart platform");
  precision::Options options;
  program.options().add_flag(
      "--quick", options.quick,
      "Two tolerances and one step for every method; Simbody's of order 1 and 2 are left out");
  program.options()
      .add_option("--repetitions", options.repetitions, "Of every run that is timed")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  program.options().add_option("--plot", options.plots, "Write SCENE.svg and SCENE.pdf to this folder");
  return program.run(argc, argv, [&] { return precision::run(program, options); });
}
