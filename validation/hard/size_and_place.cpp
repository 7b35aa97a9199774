/// Tiny and huge mechanisms, late and distant ones: the same answers by scaling. Large ones are in
/// large_mechanisms.cpp.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "integrators/implicit/newton.hpp"
#include "integrators/methods.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/methods.hpp"

namespace trivium::hard {

namespace {

using scenes::Scene, scenes::Vector3;

Vector3 times(double factor, const Vector3& x) { return {factor * x[0], factor * x[1], factor * x[2]}; }

/// The scene with its lengths times `length` and gravity times `gravity`; its motion is the same in
/// sqrt(length / gravity) times the time.
Scene scaled(Scene scene, double length, double gravity) {
  const double time = std::sqrt(length / gravity);
  for (scenes::Body& one : scene.bodies) {
    one.position = times(length, one.position);
    one.velocity = times(length / time, one.velocity);
    one.angular_velocity = times(1 / time, one.angular_velocity);
    one.inertia = times(length * length, std::get<Vector3>(one.inertia));
  }
  for (scenes::Constraint& one : scene.constraints)
    for (auto* of : {&one.i, &one.j})
      if (of->point) of->point = times(length, *of->point);
  for (scenes::Effect& effect : scene.effects)
    if (auto* g = std::get_if<Gravity<double>>(&effect)) g->acceleration *= gravity;
  return scene;
}

/// The two bars, changed: their lengths and times are these multiples, and they start elsewhere, later.
struct Changed {
  Scene scene;
  double length = 1, time = 1;     ///< factors [-]
  double start = 0, distance = 0;  ///< [s, m]
};

/// The end of a run with given steps.
struct End {
  std::vector<Eigen::Vector3d> positions;
  bool is_implicit = false;  ///< of the method
};
End end_of(const Scene& scene, double start, double end, int steps, const std::string& method,
           const std::string& formulation) {
  SimulationOptions options;
  options.integrator = method;
  options.formulation = formulation;
  options.end = end;
  options.step = (end - start) / steps;
  Samples samples;
  End end_of_run;
  end_of_run.is_implicit = simulate(make_model<double>(scene, start), options, samples).is_implicit;
  for (const auto& pose : samples.all.back().state.pose) end_of_run.positions.push_back(pose.r);
  return end_of_run;
}

/// The ends of runs of one second with the same given steps must be the same but for the change. `within`:
/// how far iterations of implicit methods may end from each other.
void judge_equal_steps(Judge& judge, const Changed& changed, int steps, double rounding, double within,
                       double amplification, const char* quantity) {
  const double end = changed.start + changed.time;
  for (const std::string& method : methods_of("size_and_place", judge.is_quick())) {
    const integrators::MethodInfo& info = *integrators::find_method(method);
    if (!info.takes_given_steps) continue;
    for (const std::string& formulation : judge.formulations()) {
      if (!goes_with(info, formulation)) continue;
      Row row = judge.row(formulation, method, quantity);
      row.amplification = amplification;
      try {
        const End a = end_of(scenes::two_bars(), 0, 1, steps, method, formulation),
                  b = end_of(changed.scene, changed.start, end, steps, method, formulation);
        for (std::size_t k = 0; k < a.positions.size(); ++k)
          raise(row.value, (a.positions[k] -
                            (b.positions[k] - changed.distance * Eigen::Vector3d::UnitX()) / changed.length)
                               .norm());
        row.tolerance = rounding + (a.is_implicit ? within : 0);
        row.threshold = factors::state * row.tolerance * amplification;
        judge.add(judge.judged(row));
      } catch (const Error& error) {
        judge.add(judge.ended(row, error.what(), error.when(), changed.scene, changed.start, end));
      }
    }
  }
}

/// One state of bars of 1 m: the largest differences of accelerations and joint reactions from those of
/// another scene, whose lengths are `length` and whose gravity is `gravity` times as large, relative to the
/// largest of each.
double apart(const FormulationResult<double>& one, const FormulationResult<double>& other, double length,
             double gravity) {
  double largest = 0;
  // the size to which differences are relative; `least`: of it
  const auto compare = [&](const auto& a, const auto& b, double scale, double least, const auto& part) {
    double off = 0, size = least;
    for (std::size_t k = 0; k < a.size(); ++k) {
      raise(off, (part(a[k]) - part(b[k]) / scale).norm());
      raise(size, part(a[k]).norm());
    }
    raise(largest, off / size);
    return size;
  };
  const auto itself = [](const auto& x) { return x; };
  const double fastest = compare(one.solution.r_ddot, other.solution.r_ddot, gravity, 0, itself);
  compare(one.solution.omega_bar_dot, other.solution.omega_bar_dot, gravity / length, fastest, itself);
  const double force =
      compare(one.reactions, other.reactions, gravity, 0, [](const auto& x) { return x.force; });
  compare(one.reactions, other.reactions, gravity * length, force, [](const auto& x) { return x.torque; });
  return largest;
}

/// `rounding`: of the lengths of the other scene [-].
void judge_state(Judge& judge, const Scene& other, double length, double gravity, double rounding) {
  const auto model = make_model<double>(scenes::two_bars()), moved = make_model<double>(other);
  const SolveOptions options{judge.formulations(), {}};
  const RowAnalysis rows = analyse_rows(model);
  const auto compare = [&](const SideBySide<double>& a, const SideBySide<double>& b, const char* solver) {
    for (std::size_t f = 0; f < a.formulations.size(); ++f) {
      Row row = judge.row(a.formulations[f].name, solver, "accelerations and reactions [-]");
      row.value = apart(a.formulations[f], b.formulations[f], length, gravity);
      promise(row, rows.kappa, unit_roundoff<double>() + rounding);
      judge.add(judge.judged(row));
    }
  };
  compare(side_by_side(model, rows, options), side_by_side(moved, analyse_rows(moved), options), "printed");
  compare(structured_side_by_side(model, options), structured_side_by_side(moved, options), "structured");
}

/// A motion of the scaled scene with chosen steps, and with given steps beside that of the unscaled scene.
void judge_scaled(Judge& judge, double length, double gravity) {
  const Scene scene = scenes::two_bars(), other = scaled(scene, length, gravity);
  const double time = std::sqrt(length / gravity);
  HardMotion motion;
  motion.scene = other;
  motion.end = time;
  motion.step = time / 1024;
  motion.length = length;
  motion.speed = length / time;
  const ExactMotion exact = judge.motion(motion);
  judge_state(judge, other, length, gravity, 0);
  constexpr int steps = 1024;
  // Powers of 4 scale without rounding. Others round the lengths, and the same step of Newton's method may
  // end with another iterate within its tolerance.
  const double log_4 = std::log2(length / gravity) / 2;
  const double within = log_4 == std::round(log_4) ? 0 : integrators::NewtonOptions{}.tolerance;
  judge_equal_steps(judge, {other, length, time}, steps, unit_roundoff<double>() * steps, within,
                    exact.amplification(), "equal steps, scaled [-]");
}

/// The two bars at a distance from the origin.
Scene distant(double distance) {
  Scene scene = scenes::two_bars();
  scene.name = fmt::format("distant_{:g}", distance);
  for (scenes::Body& one : scene.bodies) one.position[0] += distance;
  for (scenes::Constraint& one : scene.constraints)
    for (auto* of : {&one.i, &one.j})
      if (of->body == scenes::ground) of->point = Vector3{distance, 0, 0};
  return scene;
}

/// The two bars from a late time on, or at a distance. The exact motion is that from time 0 at the origin.
void judge_moved(Judge& judge, double start, double distance) {
  HardMotion here;
  here.scene = scenes::two_bars();
  here.length = 1;
  const ExactMotion exact(here);
  HardMotion motion = here;
  motion.scene = distant(distance);
  motion.start = start;
  motion.end = start + 1;
  motion.chooses_steps = distance == 0;  // rtol is a share of the distance
  // of the times, in seconds of a motion that lasts one, or of the positions
  motion.rounding = unit_roundoff<double>() * std::max(start, distance);
  constexpr double late = 1e5;  // the rounding of times is announced from about 1e4 s on
  if (start >= late) motion.reason = "nearer to t = 0";
  motion.exact = [&](MechanismState<double>& state) {
    const auto k = static_cast<std::size_t>(std::lround((state.t - start) / exact.output_step())) - 1;
    state.pose = exact.states()[k].pose;
    state.twist = exact.states()[k].twist;
    for (Pose<double>& pose : state.pose) pose.r[0] += distance;
  };
  judge.motion(motion);
  // 1e-3 s is no binary number: late times are rounded, but no step may notice
  constexpr int steps = 1000;
  judge_equal_steps(judge, {motion.scene, 1, 1, start, distance}, steps,
                    unit_roundoff<double>() * (steps + distance),
                    distance > 0 ? integrators::NewtonOptions{}.tolerance : 0, exact.amplification(),
                    "equal steps, moved [-]");
  if (distance > 0) judge_state(judge, motion.scene, 1, 1, motion.rounding);
}

}  // namespace

Family size_and_place() {
  const double tiny = std::pow(4, -10), huge = std::pow(4, 5);  // powers of 4 scale without rounding
  std::vector<Case> cases = large_mechanisms();
  cases.insert(cases.end(), {{"length",
                              "factor of all lengths",
                              {1e-7, 1e7},
                              1,
                              {tiny},
                              {tiny, huge},
                              [](Judge& judge, double length) { judge_scaled(judge, length, 1); },
                              [](double length) { return scaled(scenes::two_bars(), length, 1); }},
                             {"gravity",
                              "factor of gravity",
                              {1e-12, 1e12},
                              1,
                              {},
                              {std::pow(4, -15), std::pow(4, 15)},
                              [](Judge& judge, double gravity) { judge_scaled(judge, 1, gravity); },
                              [](double gravity) { return scaled(scenes::two_bars(), 1, gravity); }},
                             {"late",
                              "time of the start [s]",
                              {0, 1e8},
                              0,
                              {1e6},
                              {1e3, 1e6},
                              [](Judge& judge, double start) { judge_moved(judge, start, 0); }},
                             {"distant",
                              "distance from the origin [m]",
                              {0, 1e9},
                              0,
                              {1e6},
                              {1e3, 1e6},
                              [](Judge& judge, double away) { judge_moved(judge, 0, away); },
                              distant}});
  return {"size_and_place", "large, tiny, huge, late and distant mechanisms", std::move(cases)};
}

}  // namespace trivium::hard
