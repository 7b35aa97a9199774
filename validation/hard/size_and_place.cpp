/// Large mechanisms, tiny and huge ones, late and distant ones: the same answers by scaling.

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/raise.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "integrators/methods.hpp"
#include "scenes/building.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/methods.hpp"

namespace trivium::hard {

namespace {

using building::body, building::joint, building::side;
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
        judge.add(judge.ended(row, error.what(), error.when()));
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

/// n bars in a plane that form a zigzag; each is inclined by `angle` [rad] to the straight line, so that 0 is
/// straight and nearly pi / 2 is folded.
Scene zigzag(int n, double angle) {
  Scene scene;
  scene.name = fmt::format("zigzag_{:g}", angle);
  const Vector3 y{0, 1, 0}, back{-0.5, 0, 0}, front{0.5, 0, 0};
  double x = 0, z = 0;
  for (int k = 0; k < n; ++k) {
    const double turn = k % 2 == 0 ? angle : -angle, c = std::cos(turn), s = -std::sin(turn);
    scene.bodies.push_back(
        body(fmt::format("bar_{}", k + 1), 1, {0.01, 0.1, 0.1}, {x + c / 2, 0, z + s / 2}));
    scene.bodies.back().orientation = scenes::AxisAngle{y, turn};
    scene.constraints.push_back(joint(JointType::revolute, fmt::format("J{}", k + 1),
                                      side(k == 0 ? scenes::ground : k - 1, k == 0 ? Vector3{} : front, y),
                                      side(k, back, y)));
    x += c;
    z += s;
  }
  scene.effects = {building::gravity()};
  return scene;
}

/// lambda of the linear-time solver against the same solver in quad.
void judge_large(Judge& judge, const Scene& scene) {
  const auto model = make_model<double>(scene);
  const auto quad = make_model<Quad>(scene);
  AccelerationSolver<ROmega<Quad>> solver(quad.mechanism);
  solver.solve(to_coordinates<ROmega<Quad>>(quad.mechanism, quad.state, {}), quad.state.t);
  const VectorX<double> exact = scalar_cast<double>(solver.lambda());
  const SideBySide<double> answer = structured_side_by_side(model, SolveOptions{judge.formulations(), {}});
  for (const FormulationResult<double>& found : answer.formulations) {
    Row row = judge.row(found.name, "structured", "lambda [-]");
    row.tolerance = unit_roundoff<double>();
    // the condition number of a chain grows with the square of its length
    row.amplification = std::pow(static_cast<double>(scene.bodies.size()), 2);
    row.threshold = factors::state * row.tolerance * row.amplification;
    if (!found.error.empty()) {
      judge.add(judge.ended(row, found.error, 0.0));
      continue;
    }
    row.value = (found.solution.lambda - exact).lpNorm<Eigen::Infinity>() / exact.lpNorm<Eigen::Infinity>();
    judge.add(judge.judged(row));
  }
}

constexpr int many = 1000;

}  // namespace

Family size_and_place() {
  const double tiny = std::pow(4, -10), huge = std::pow(4, 5);  // powers of 4 scale without rounding
  const auto generated = [](const char* name, Scene (*make)(int), int least) {
    return Case{name,
                "number of bodies",
                static_cast<double>(least),
                {100},
                {many},
                [make](Judge& judge, double n) { judge_large(judge, make(static_cast<int>(n))); },
                [make](double n) { return make(static_cast<int>(n)); }};
  };
  return {
      "size_and_place",
      "large, tiny, huge, late and distant mechanisms",
      {generated("chain", scenes::chain, 3),
       generated("ring", scenes::ring, 5),
       generated("ladder", scenes::ladder, 3),
       generated(
           "random_tree", [](int n) { return scenes::tree(n); }, 3),
       {"zigzag",
        "inclination of each of a thousand bars [rad]",
        0.5,
        {0},
        {0, 1, 1.5, 1.57},
        [](Judge& judge, double angle) { judge_large(judge, zigzag(judge.is_quick() ? 100 : many, angle)); },
        [](double angle) { return zigzag(many, angle); }},
       {"length",
        "factor of all lengths",
        1,
        {tiny},
        {tiny, huge},
        [](Judge& judge, double length) { judge_scaled(judge, length, 1); },
        [](double length) { return scaled(scenes::two_bars(), length, 1); }},
       {"gravity",
        "factor of gravity",
        1,
        {},
        {std::pow(4, -15), std::pow(4, 15)},
        [](Judge& judge, double gravity) { judge_scaled(judge, 1, gravity); },
        [](double gravity) { return scaled(scenes::two_bars(), 1, gravity); }},
       {"late", "time of the start [s]", 0, {1e6}, {1e3, 1e6}, judge_late},
       {"distant", "distance from the origin [m]", 0, {1e6}, {1e3, 1e6}, judge_distant, distant}}};
}

}  // namespace trivium::hard
