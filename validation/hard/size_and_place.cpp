/// Tiny and huge mechanisms, late and distant ones: the same answers by scaling. Large ones are in
/// large_mechanisms.cpp.

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "bodies/numbers/scalar.hpp"
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

/// The largest difference of positions at the ends of two runs with the same number of given steps, relative
/// to the length of each.
double apart_after_equal_steps(const Scene& one, const Scene& other, double length, double time,
                               const std::string& method, const std::string& formulation, int steps) {
  const auto end_of = [&](const Scene& scene, double end) {
    SimulationOptions options;
    options.integrator = method;
    options.formulation = formulation;
    options.end = end;
    options.step = end / steps;
    Samples samples;
    simulate(make_model<double>(scene), options, samples);
    return samples.all.back().state;
  };
  const MechanismState<double> a = end_of(one, 1), b = end_of(other, time);
  double largest = 0;
  for (std::size_t k = 0; k < a.pose.size(); ++k) raise(largest, (a.pose[k].r - b.pose[k].r / length).norm());
  return largest;
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
  judge.motion(motion);
  constexpr int steps = 1024;
  for (const std::string& method : methods_of("size_and_place", judge.is_quick())) {
    const integrators::MethodInfo& info = *integrators::find_method(method);
    if (!info.takes_given_steps) continue;
    for (const std::string& formulation : judge.formulations()) {
      if (!goes_with(info, formulation)) continue;
      Row row = judge.row(formulation, method, "equal steps, scaled [-]");
      row.tolerance = unit_roundoff<double>() * steps;
      row.threshold = factors::state * row.tolerance;
      try {
        row.value = apart_after_equal_steps(scene, other, length, time, method, formulation, steps);
        judge.add(judge.judged(row));
      } catch (const Error& error) {
        judge.add(judge.ended(row, error.what(), error.when(), other, 0, time));
      }
    }
  }
}

/// The two bars from a late time on. The exact motion is that from time 0.
void judge_late(Judge& judge, double start) {
  HardMotion early;
  early.scene = scenes::two_bars();
  const ExactMotion exact(early);
  HardMotion motion = early;
  motion.start = start;
  motion.end = start + 1;
  motion.rounding = unit_roundoff<double>() * start;  // of the times, in seconds of a motion that lasts one
  motion.exact = [&](MechanismState<double>& state) {
    const auto k = static_cast<std::size_t>(std::lround((state.t - start) / exact.output_step())) - 1;
    state.pose = exact.states()[k].pose;
    state.twist = exact.states()[k].twist;
  };
  judge.motion(motion);
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

void judge_distant(Judge& judge, double distance) {
  HardMotion motion;
  motion.scene = distant(distance);
  motion.length = 1;
  motion.chooses_steps = false;  // rtol is a share of the distance
  motion.rounding = unit_roundoff<double>() * distance;
  judge.motion(motion);
}

}  // namespace

Family size_and_place() {
  const double tiny = std::pow(4, -10), huge = std::pow(4, 5);  // powers of 4 scale without rounding
  std::vector<Case> cases = large_mechanisms();
  cases.insert(
      cases.end(),
      {{"length",
        "factor of all lengths",
        {1e-6, 1e6},
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
       {"late", "time of the start [s]", {0, 1e9}, 0, {1e6}, {1e3, 1e6}, judge_late},
       {"distant", "distance from the origin [m]", {0, 1e9}, 0, {1e6}, {1e3, 1e6}, judge_distant, distant}});
  return {"size_and_place", "large, tiny, huge, late and distant mechanisms", std::move(cases)};
}

}  // namespace trivium::hard
