/// Faults: forces that overflow, steps that underflow, memory and disks that are full, signals. The program
/// `trivium` runs as a child process: its exit code and its messages must say what happened, and what was
/// computed must be on disk and valid.

#include <fmt/format.h>

#include <cmath>

#include "base/exit_code.hpp"
#include "integrators/methods.hpp"
#include "scenes/building.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/child_run.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/fault_rows.hpp"
#include "validation/hard/losses.hpp"
#include "validation/hard/methods.hpp"

namespace trivium::hard {

namespace {

using building::body, building::joint, building::side;
using scenes::ground, scenes::Scene, scenes::Vector3;

/// Calls visit(row, options) for every formulation and method of the family.
template <class Visit>
void for_every_method(Judge& judge, bool also_given_steps, const Visit& visit) {
  for (const std::string& formulation : judge.formulations())
    for (const std::string& method : methods_of("faults", judge.is_quick())) {
      const integrators::MethodInfo& info = *integrators::find_method(method);
      if (!goes_with(info, formulation)) continue;
      const Options options{"--formulation", formulation, "--integrator", method};
      if (info.chooses_steps) visit(row_of_end(judge, formulation, method), options);
      if (info.takes_given_steps && also_given_steps)
        visit(row_of_end(judge, formulation, method + ", h = 0.001"), options + Options{"--step", "0.001"});
    }
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
           {"failing_allocation",
            "number of runs by dopri5; by each other method a sixteenth",
            {0, 1e6, true},
            0,
            {40},
            {5000},
            judge_allocations},
           {"full_disk",
            "size to which a file can grow [bytes]",
            {0, 1e12},
            1e9,
            {4096},
            {0, 1, 100, 4096, 8191, 8192, 16384},
            judge_full_disk},
           {"interrupt",
            "number of runs by dopri5; by each other method a sixteenth",
            {0, 1000, true},
            0,
            {4},
            {16},
            judge_interrupt},
           {"terminate",
            "number of runs by dopri5; by each other method a sixteenth",
            {0, 1000, true},
            0,
            {4},
            {16},
            judge_termination}}};
}

}  // namespace trivium::hard
