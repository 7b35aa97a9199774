/// Faults: forces that overflow, steps that underflow, memory and disks that are full, signals. The program
/// `trivium` runs as a child process: its exit code and its messages must say what happened, and what was
/// computed must be on disk and valid.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <map>
#include <random>
#include <regex>

#include "base/exit_code.hpp"
#include "integrators/methods.hpp"
#include "scenes/building.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/child_run.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/methods.hpp"

namespace trivium::hard {

namespace {

using building::body, building::gravity, building::joint, building::side;
using scenes::ground, scenes::Scene, scenes::Vector3;

using Options = std::vector<std::string>;

Options operator+(Options all, const Options& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// A row about the end of a run. Its value will be the number of runs with something wrong.
Row row_of(const Judge& judge, const std::string& formulation, const std::string& method) {
  return judge.row(formulation, method, "exit code and files [wrong runs]");
}
Row row_of(const Judge& judge, const std::string& what) {
  return row_of(judge, judge.formulations().front(), "dopri5, " + what);
}

/// Adds the row of runs of which `wrong` holds what is wrong with each; empty texts do not count.
/// `announced`: whether one of them ended with a message.
void settle(Judge& judge, Row row, bool announced, std::vector<std::string> wrong, const std::string& why) {
  std::erase(wrong, "");
  row.value = static_cast<double>(wrong.size());
  row.threshold = factors::wrong_runs;
  row.verdict = !row.is_met() ? Verdict::fails : announced ? Verdict::announces : Verdict::survives;
  row.why = (wrong.empty() ? "" : wrong.front() + (why.empty() ? "" : "; ")) + why;
  row.why = std::regex_replace(row.why, std::regex("incomplete-[0-9]+"), "incomplete-N");
  std::replace(row.why.begin(), row.why.end(), '\n', ' ');
  judge.add(row);
}

/// Calls visit(row, options) for every formulation and method of the family.
template <class Visit>
void for_every_method(Judge& judge, bool also_given_steps, const Visit& visit) {
  for (const std::string& formulation : judge.formulations())
    for (const std::string& method : methods_of("faults", judge.is_quick())) {
      const integrators::MethodInfo& info = *integrators::find_method(method);
      if (!goes_with(info, formulation)) continue;
      const Options options{"--formulation", formulation, "--integrator", method};
      if (info.chooses_steps) visit(row_of(judge, formulation, method), options);
      if (info.takes_given_steps && also_given_steps)
        visit(row_of(judge, formulation, method + ", h = 0.001"), options + Options{"--step", "0.001"});
    }
}

constexpr double onset = 0.5;  ///< time [s] at which the push begins

/// A pendulum that is pushed by the force (c t)^4 from the onset on.
Scene pushed_pendulum(double c) {
  const TimeFunction line = TimeFunction::Polynomial{{0, c}},
                     push = TimeFunction::Product{{line, line, line, line}};
  Scene scene;
  scene.name = fmt::format("pushed_pendulum_{:g}", c);
  scene.bodies = {body("rod", 1, {0.1, 0.2, 0.3}, {1, 0, 0})};
  scene.constraints = {joint(JointType::revolute, "hinge", side(ground, Vector3{}, Vector3{0, 1, 0}),
                             side(0, Vector3{-1, 0, 0}, Vector3{0, 1, 0}))};
  Force<double> force;
  force.name = "push";
  force.components[2] = TimeFunction::Piecewise{{onset}, {TimeFunction(0), push}};
  scene.effects = {gravity(), force};
  return scene;
}

/// The outputs before the force overflows must be those of a pendulum that is not pushed.
void judge_push(Judge& judge, double c) {
  const Workplace pushed(judge.choice().program, pushed_pendulum(c)),
      left_alone(judge.choice().program, pushed_pendulum(0));
  for_every_method(judge, true, [&](const Row& row, const Options& method) {
    const Options options = method + Options{"--t-end", "1", "--output-step", "0.01"};
    const Run run = pushed.simulate(options);
    if (judge.is_twin()) return settle(judge, row, false, {wrong_unharmed(run, 1)}, "");
    const std::string free = Motion(left_alone.simulate(options)).text(),
                      before = free.substr(0, free.find(fmt::format("\n{:.17g},", onset)) + 1);
    std::string wrong = wrong_in_failure(run, pushed_pendulum(c), 1, onset, "\"push\"");
    if (wrong.empty() && !Motion(run).text().starts_with(before))
      wrong = "outputs before the push are missing";
    settle(judge, row, true, {wrong}, first_line(run.ended.err));
  });
}

/// A slider on a rail along x.
Scene slider(const std::string& name, double x, const scenes::Effect& effect) {
  Scene scene;
  scene.name = name;
  scene.bodies = {body("slider", 1, {0.1, 0.2, 0.3}, {x, 0, 0})};
  const Vector3 along{1, 0, 0}, across{0, 1, 0};
  scene.constraints = {
      joint(JointType::translational, "rail", side(ground, {}, along, across), side(0, {}, along, across))};
  scene.effects = {effect};
  return scene;
}

/// From t_0 = 0.5 s on the force is w sin(w (t - t_0)), so that x = t - t_0 - sin(w (t - t_0)) / w.
constexpr double shaken_from = 0.5;
Scene shaken_slider(double w) {
  Force<double> force;
  force.name = "shaking";
  force.components[0] = TimeFunction::Product{
      {TimeFunction::Piecewise{{shaken_from}, {0, 1}}, TimeFunction::Harmonic{0, w, w, -w * shaken_from}}};
  return slider(fmt::format("shaken_slider_{:g}", w), 0, force);
}

/// A run must end at the position x, or with an announcement.
void judge_slider(Judge& judge, const Scene& scene, double tolerance, double end, double x) {
  const Workplace place(judge.choice().program, scene);
  for_every_method(judge, false, [&](Row row, const Options& method) {
    const std::string limit = fmt::format("{}", tolerance);
    Run run = place.simulate(
        method + Options{"--json", "--rtol", limit, "--atol", limit, "--t-end", fmt::format("{}", end)});
    const std::string message = first_line(run.ended.err);
    if (!judge.is_twin() && run.ended.exit_code != exit_done)
      return settle(judge, row, true, {wrong_in_failure(run, scene, end, shaken_from, "\"shaking\"")},
                    message);
    if (!judge.is_twin()) run.ended.err.clear();  // warnings are judged with the error
    if (const std::string wrong = wrong_unharmed(run, end); !wrong.empty())
      return settle(judge, row, false, {wrong}, "");
    row.quantity = "position at the end [m]";
    row.value = std::abs(Motion(run).last()[1] - x);
    row.tolerance = number_after(run.ended.out, "\"steps\": ") * 2 * tolerance;
    row.amplification = 1;  // a wrong velocity acts for 1 s at most
    row.threshold = factors::law * row.tolerance * row.amplification;
    row.why = message;
    judge.add(judge.judged(row));  // a message without a figure states no error
  });
}

/// `tries`: how many allocations fail, each in a run of its own; afterwards there is memory again, or not.
void judge_allocations_by(Judge& judge, const std::string& method, double tries) {
  const Workplace place(judge.choice().program, pushed_pendulum(0));
  const std::string& formulation = judge.formulations().front();
  Options options{"--formulation", formulation,     "--integrator", method,       "--t-end",
                  "0.02",          "--output-step", "0.005",        "--save-end", place.file("end.json")};
  if (!integrators::find_method(method)->chooses_steps) options = options + Options{"--step", "0.001"};
  const std::string preload = "LD_PRELOAD=" TRIVIUM_FAILING_ALLOCATOR;
  Command counting;
  counting.environment = {preload, "TRIVIUM_ALLOCATION_COUNT_FILE=" + place.file("count")};
  Run whole = place.simulate(options, counting);
  const double all = whole.files.contains("count") ? std::stod(whole.files["count"]) : 0,
               tried = std::min(tries, all);
  whole.files.erase("count");
  const std::string harm = all > 0 ? wrong_unharmed(whole, 0.02) : "allocations are not counted";
  if (!harm.empty())
    return settle(judge, row_of(judge, formulation, method + ", no allocation fails"), false, {harm}, "");
  for (const bool is_once : {true, false}) {
    std::vector<std::string> wrong;
    std::map<std::string, int> ends;
    bool announced = false;
    for (double k = 0; k < tried; ++k) {
      const long first = 1 + static_cast<long>(k * all / tried),
                 last = is_once ? first : std::numeric_limits<long>::max();
      Command failing;
      failing.environment = {preload, fmt::format("TRIVIUM_FIRST_FAILING_ALLOCATION={}", first),
                             fmt::format("TRIVIUM_LAST_FAILING_ALLOCATION={}", last)};
      const Run run = place.simulate(options, failing);
      ++ends[run.ended.text()];
      announced = announced || run.ended.exit_code != exit_done;
      if (const std::string lost = wrong_in_loss(run, whole); !lost.empty())
        wrong.push_back(fmt::format("allocation {}: {}", first, lost));
    }
    std::string why = fmt::format("{} of {} allocations", tried, all);
    for (const auto& [end, count] : ends) why += fmt::format(", {} times {}", count, end);
    settle(
        judge,
        row_of(judge, formulation, method + (is_once ? ", one allocation fails" : ", all fail from one on")),
        announced, wrong, why);
  }
}

/// By methods other than the first fewer runs: most allocations are the same.
void judge_allocations(Judge& judge, double tries) {
  if (!TRIVIUM_ALLOCATIONS_CAN_FAIL) {
    Row row = row_of(judge, "failing allocations");
    row.value = std::numeric_limits<double>::quiet_NaN();
    row.verdict = Verdict::not_judged;
    row.why = "this build has the allocator of a sanitizer";
    return judge.add(row);
  }
  const std::vector<std::string>& methods = methods_of("failing_allocation", judge.is_quick());
  for (const std::string& method : methods)
    judge_allocations_by(judge, method, method == methods.front() ? tries : std::ceil(tries / 16));
}

void judge_full_disk(Judge& judge, double bytes) {
  const Workplace place(judge.choice().program, pushed_pendulum(0));
  const Options options{"--t-end", "0.5", "--output-step", "0.01", "--save-end", place.file("end.json")};
  const Run whole = place.simulate(options);
  if (const std::string wrong = wrong_unharmed(whole, 0.5); !wrong.empty())
    return settle(judge, row_of(judge, "an empty disk"), false, {wrong}, "");
  for (const bool raises : {false, true}) {
    Command how;
    how.largest_file = static_cast<std::uint64_t>(bytes);
    how.raises_at_largest_file = raises;
    const Run run = place.simulate(options, how);
    std::string wrong = judge.is_twin() ? wrong_unharmed(run, 0.5) : wrong_in_loss(run, whole);
    if (wrong.empty() && !Motion(run).text().empty() && Motion(run).text() != Motion(whole).text())
      wrong = "motion.csv is not whole";
    settle(judge, row_of(judge, raises ? "limited files (SIGXFSZ)" : "full disk"),
           run.ended.exit_code != exit_done, {wrong}, run.ended.err);
  }
  if (judge.is_twin()) return;
  Command how;
  how.out_file = "/dev/full";
  const Run run = place.simulate(options, how);
  std::string wrong =
      run.ended.exit_code == exit_done ? "exit code 0 without a report" : wrong_in_loss(run, whole);
  if (wrong.empty() && run.files != whole.files) wrong = "files are not whole";
  settle(judge, row_of(judge, "full stdout"), true, {wrong}, run.ended.err);
}

/// `runs`: each would take hours, and gets the signal within a second.
void judge_signal(Judge& judge, double runs, int signal, const char* name) {
  const Workplace place(judge.choice().program, pushed_pendulum(0));
  const auto options = [](const char* end) {
    return Options{"--output-step", "2", "--rtol", "1e-12", "--t-end", end};
  };
  const Run whole = place.simulate(options("1000"));
  if (const std::string wrong = wrong_unharmed(whole, 1000); !wrong.empty())
    return settle(judge, row_of(judge, name), false, {wrong}, "");
  std::vector<std::string> wrong;
  std::mt19937 random(1);
  int interrupted = 0;
  for (double k = 0; k < runs; ++k) {
    Command how;
    how.kill = Kill{signal, static_cast<double>(random()) / 0x1p32};
    const Run run = place.simulate(options("1e8"), how);
    if (run.ended.exit_code == exit_interrupted) ++interrupted;
    if (const std::string lost = wrong_after_signal(run, whole, signal); !lost.empty())
      wrong.push_back(fmt::format("after {:.3f} s: {}", how.kill->after, lost));
  }
  if (runs > 0 && interrupted == 0) wrong.emplace_back("no run was interrupted");
  settle(judge, row_of(judge, name), interrupted > 0, wrong, fmt::format("{} runs", runs));
}

}  // namespace

Family faults() {
  return {"faults",
          "forces that overflow, steps that underflow, full memory and disks, signals",
          {{"non_finite_force",
            "c of the force (c t)^4 [N^(1/4)/s]",
            {1e20, 1e100},
            1,
            {1e60, 1e80},
            {1e20, 1e40, 1e60, 1e80, 1e100},
            judge_push,
            pushed_pendulum},
           {"step_underflow",
            "angular frequency of the force [rad/s]",
            {1e30, 1e100},
            10,
            {1e30},
            {1e30, 1e60, 1e90},
            [](Judge& judge, double w) {
              constexpr double shaken = 1 - shaken_from;
              judge_slider(judge, shaken_slider(w), 1e-8, 1, shaken - std::sin(w * shaken) / w);
            },
            shaken_slider},
           {"failing_allocation", "number of runs", {0, 1e6, true}, 0, {40}, {4000}, judge_allocations},
           {"full_disk",
            "size to which a file can grow [bytes]",
            {0, 1e12},
            1e9,
            {4096},
            {0, 1, 100, 4096, 8191, 8192, 16384},
            judge_full_disk},
           {"interrupt",
            "number of runs",
            {0, 1000, true},
            0,
            {4},
            {30},
            [](Judge& judge, double runs) { judge_signal(judge, runs, SIGINT, "SIGINT"); }},
           {"terminate", "number of runs", {0, 1000, true}, 0, {4}, {30}, [](Judge& judge, double runs) {
              judge_signal(judge, runs, SIGTERM, "SIGTERM");
            }}}};
}

}  // namespace trivium::hard
