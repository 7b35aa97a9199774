/// Singular and badly scaled mass matrices: thin rods, point masses, a spin that nothing determines, and
/// masses of very different size in a chain and in a loop.

#include <fmt/format.h>

#include <cmath>

#include "scenes/building.hpp"
#include "scenes/catalogue.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/placing.hpp"
#include "validation/hard/solved_state.hpp"

namespace trivium::hard {

namespace {

using building::body, building::gravity, building::joint, building::side;
using scenes::Scene, scenes::Vector3;

const Vector3 z{0, 0, 1};

/// A rod of this moment of inertia about its own axis x, which hangs on a joint to the ground and swings.
Scene rod_on(JointType type, double axial) {
  Scene scene;
  scene.name = fmt::format("rod_{:g}", axial);
  scenes::Body rod = body("rod", 1, {axial, 0.1, 0.1});
  rod.orientation = scenes::AxisAngle{{0, 0.6, 0.8}, 0.7};
  const Vector3 tip{-1, 0, 0};
  const bool is_universal = type == JointType::universal;
  // about the axis of the universal joint on the rod
  rod.angular_velocity = is_universal ? Vector3{0, 0.9, 0} : Vector3{0.8, 0.9, -0.4};
  pin_at_origin(rod, tip);
  scene.bodies = {rod};
  if (is_universal) {
    // the ground's axis is normal to the rod's y axis, which the orientation maps to (0.8, ...)
    const Vector3 y = direction_in_ground(rod, {0, 1, 0});
    const double length = std::hypot(y[0], y[1]);
    scene.constraints = {joint(type, "pivot",
                               side(scenes::ground, Vector3{}, Vector3{y[1] / length, -y[0] / length, 0}),
                               side(0, tip, Vector3{0, 1, 0}))};
  } else {
    scene.constraints = {joint(type, "pivot", side(scenes::ground, Vector3{}), side(0, tip))};
  }
  scene.effects = {gravity()};
  return scene;
}
Scene held_rod(double axial) { return rod_on(JointType::universal, axial); }
Scene free_rod(double axial) { return rod_on(JointType::spherical, axial); }

/// A pendulum on a revolute with a small body welded to its tip, whose moments of inertia are all `moment`.
Scene point_mass(double moment) {
  Scene scene;
  scene.name = fmt::format("point_mass_{:g}", moment);
  scene.bodies = {body("rod", 1, {0.01, 0.1, 0.1}, {0.5, 0, 0}),
                  body("tip", 0.5, {moment, moment, moment}, {1, 0, 0})};
  for (scenes::Body& one : scene.bodies) {
    one.angular_velocity = {0, 2, 0};
    one.velocity = {0, 0, -2 * one.position[0]};
  }
  const Vector3 y{0, 1, 0};
  scene.constraints = {joint(JointType::revolute, "pivot", side(scenes::ground, Vector3{}, y),
                             side(0, Vector3{-0.5, 0, 0}, y)),
                       joint(JointType::fixed, "weld", side(0, Vector3{0.5, 0, 0}, y, Vector3{1, 0, 0}),
                             side(1, Vector3{}, y, Vector3{1, 0, 0}))};
  scene.effects = {gravity()};
  return scene;
}

void scale_mass(scenes::Body& one, double ratio) {
  one.mass *= ratio;
  for (double& moment : std::get<Vector3>(one.inertia)) moment *= ratio;
}

/// Three bars on revolutes; the middle one has `ratio` times the mass of the others.
Scene mass_chain(double ratio, bool moves) {
  Scene scene;
  scene.name = fmt::format("mass_chain_{:g}", ratio);
  const double rate = moves ? 1.5 : 0;
  for (int k = 0; k < 3; ++k) {
    scenes::Body bar = body(fmt::format("bar_{}", k + 1), 1, {0.01, 0.1, 0.1}, {k + 0.5, 0, 0});
    bar.angular_velocity = {0, 0, rate};
    bar.velocity = {0, rate * bar.position[0], 0};
    if (k == 1) scale_mass(bar, ratio);
    scene.bodies.push_back(bar);
    const Vector3 inner = k == 0 ? Vector3{} : Vector3{0.5, 0, 0};
    scene.constraints.push_back(joint(JointType::revolute, fmt::format("J{}", k + 1),
                                      side(k == 0 ? scenes::ground : k - 1, inner, z),
                                      side(k, Vector3{-0.5, 0, 0}, z)));
  }
  scene.effects = {Gravity<double>{"", {0, -9.81, 0}}};
  return scene;
}

/// The spatial slider-crank, whose rod has `ratio` times its mass.
Scene mass_loop(double ratio, bool moves) {
  Scene scene = load_scene("spatial_slider_crank");
  scene.name = fmt::format("mass_loop_{:g}", ratio);
  scale_mass(scene.bodies[1], ratio);
  scene.effects = {gravity()};
  for (scenes::Body& one : scene.bodies)
    if (!moves) one.velocity = one.angular_velocity = {};
  return scene;
}

void judge_state(Judge& judge, const Scene& scene, const std::string& at) {
  const SolvedStates solved = solve_state(scene, judge.formulations());
  for (const SolvedState& state : solved.all) {
    Row row = judge.row(state.formulation, state.solver, fmt::format("lambda {} [-]", at));
    row.value = state.lambda;
    promise(row, solved.kappa);
    judge.add(state.refusal.empty() ? judge.judged(row, state.announced)
                                    : judge.refused(row, state.refusal, scene));
  }
}

void judge_motion(Judge& judge, const Scene& scene, double end = 1) {
  HardMotion motion;
  motion.scene = scene;
  // no method warns of such short steps
  motion.end = judge.is_twin() ? end / 5 : end;
  motion.step = judge.is_twin() ? 5e-5 : 5e-4;
  motion.reference = ReferenceRun::in_quad;
  motion.starts = 5;
  judge.motion(motion);
}

template <Scene (*make)(double, bool)>
Case of_masses(const std::string& name) {
  return {name,
          "ratio of masses",
          {1e-14, 1e14},
          2,
          {1e9},
          {1e-12, 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9, 1e12},
          [](Judge& judge, double ratio) {
            judge_state(judge, make(ratio, false), "at rest");
            judge_state(judge, make(ratio, true), "in motion");
            judge_motion(judge, make(ratio, true), 0.5);
          },
          [](double ratio) { return make(ratio, true); }};
}

}  // namespace

Family inertia() {
  const std::vector<double> moments{1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 0};
  const auto motion_of = [](Scene (*make)(double)) {
    return [make](Judge& judge, double moment) { judge_motion(judge, make(moment)); };
  };
  return {"inertia",
          "thin rods, point masses, ratios of masses",
          {{"held_rod",
            "axial moment of inertia [kg m^2]",
            {0, 0.2},
            0.05,
            {0},
            moments,
            motion_of(held_rod),
            held_rod},
           {"free_rod",
            "axial moment of inertia [kg m^2]",
            {0, 0.2},
            0.05,
            {1e-6, 0},
            {1e-2, 1e-4, 1e-6, 1e-9, 0},
            motion_of(free_rod),
            free_rod},
           {"point_mass",
            "moments of inertia [kg m^2]",
            {0, 10},
            0.05,
            {0},
            moments,
            motion_of(point_mass),
            point_mass},
           of_masses<mass_chain>("mass_chain"),
           of_masses<mass_loop>("mass_loop")}};
}

}  // namespace trivium::hard
