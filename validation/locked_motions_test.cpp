/// Locked mechanisms, and unconnected mechanisms in one scene. Each connected component has its own scales of
/// speed and energy; its loads set their lower limits.

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "scenes/testing/scene_builders.hpp"
#include "simulation/step_verification.hpp"
#include "simulation/system/energy_account.hpp"
#include "validation/testing/catalogue_motion.hpp"
#include "validation/testing/every_method.hpp"

namespace trivium {
namespace {

using scenes::Scene, scenes::Vector3;
using test::catalogue_scene, test::formulations_of, test::Motion, test::options_for, test::side,
    test::stepping, test::tight;

/// A body that hangs at rest on spherical joints at these points of the body.
Scene hung_on(const std::vector<Vector3>& points) {
  Scene scene;
  scene.name = "hung";
  scene.bodies = {test::body("b", 1, {0.1, 0.2, 0.15}, {1, 0, 0})};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vector3& p = points[k];
    scene.constraints.push_back(test::joint(JointType::spherical, fmt::format("s{}", k),
                                            side(scenes::ground, Vector3{p[0] + 1, p[1], p[2]}), side(0, p)));
  }
  scene.effects = {Gravity<double>{"", {0, -9.81, 0}}};
  return scene;
}
/// Three pins, the last of which misses the line of the others by `off` [m].
Scene hung_on_a_line(double off) { return hung_on({{-1, 0, 0}, {-1, 0, 1}, {-1, off, 2}}); }

// its velocities are rounding, which falls with no order
TEST(Locked, ABodyIsVerifiedWithoutAlarm) {
  const Model<double> held = make_model<double>(hung_on_a_line(0.1));
  for (const char* method : {"radau5", "generalized-alpha", "rkf78"})
    for (const ErrorByHalving& error : verify_steps(held, stepping("r-omega", method, 1, 1e-2)))
      EXPECT_TRUE(error.is_reliable()) << method << ", " << error.quantity << " " << error.error;
}

// The rank tolerance says whether the last of three pins nearly in one line holds the body.
TEST(Locked, PinsNearlyInOneLineHoldTheBodyIfTheRankToleranceSaysSo) {
  Scene scene = hung_on_a_line(3e-6);
  for (const char* method : {"dopri5", "rkf78", "cvode-bdf"}) {
    const auto fall = [&](double tolerance) {
      scene.rank_tolerance = tolerance;
      return -Motion(scene, tight("r-omega", method, 0.1, 1e-8)).end().state.pose[0].r.y();
    };
    EXPECT_LT(std::abs(fall(standard_rank_tolerance)), 1e-8) << method;
    EXPECT_GT(fall(1e-5), 0.01) << method;
    EXPECT_THROW(fall(1e-9), Error) << method;
  }
}

// Shares of 7e-8 and 2e-8, above the rank tolerance. Their squares, the pivots, are rounding errors.
TEST(Locked, PinsThatMissALineByLessThanAMicrometreHoldTheBody) {
  for (const double off : {3e-7, 1e-7})
    for (const std::string formulation : {"r-omega", "r-p", "r-epsilon"})
      for (const char* method : {"dopri5", "rkf78", "cvode-bdf", "radau5", "ida"}) {
        if (formulation == "r-epsilon" && method == std::string("ida")) continue;  // docs/limits.md
        const Motion motion(hung_on_a_line(off), tight(formulation, method, 0.3, 1e-8));
        EXPECT_LT(std::abs(motion.end().state.pose[0].r.y()), 1e-8) << off << formulation << method;
        EXPECT_LT(motion.report.counters.steps, 1000) << off << formulation << method;
      }
}

/// A block that slides and turns on a plane. Two points of its x axis, `apart` [m] from each other, cannot
/// leave the plane.
Scene block_on_a_plane(double apart) {
  Scene scene;
  scene.name = "block";
  scene.bodies = {test::body("block", 1, {0.1, 0.2, 0.15})};
  scene.bodies[0].velocity = {0.3, 0, 0};
  scene.bodies[0].angular_velocity = {1, 0, 2};
  for (const double x : {0.3, 0.3 + apart}) {
    scene.constraints.push_back(test::joint(basic_type<CD>, fmt::format("row {}", x),
                                            side(scenes::ground, Vector3{}), side(0, Vector3{x, 0, 0})));
    scene.constraints.back().direction = {0, 0, 1};
  }
  scene.effects = {Gravity<double>{"", {0, 0, -9.81}},
                   Torque<double>{"", 0, {0.1, 0.4, 0.2}, ComponentFrame::body}};
  return scene;
}

TEST(NearlyDependentRows, HoldAMovingBodyAsRowsFarApartDo) {
  for (const std::string formulation : {"r-omega", "r-p", "r-epsilon"}) {
    const Motion far(block_on_a_plane(1), tight(formulation, "rkf78", 1, 1e-11));
    for (const double apart_by : {1e-6, 1e-7})
      for (const char* method : {"dopri5", "rkf78", "cvode-bdf", "radau5"}) {
        const Motion near(block_on_a_plane(apart_by), tight(formulation, method, 1, 1e-8));
        EXPECT_LE(apart(near, far), 1e-6) << apart_by << formulation << method;
      }
  }
}

/// A lever that a hinge and a row cd hold at rest, up to rounding of its velocity.
Scene held_lever() {
  Scene scene;
  scene.name = "lever";
  scene.bodies = {test::body("lever", 3, {0.6, 1.4, 1.2}, {0.4, 0, 0})};
  scene.bodies[0].velocity = {0, 2e-31, 0};
  scene.bodies[0].angular_velocity = {0, 0, 5e-31};
  auto hold = test::joint(basic_type<CD>, "hold", side(scenes::ground, Vector3{0.8, 0, 0}),
                          side(0, Vector3{0.4, 0, 0}));
  hold.direction = {0.1, 0.9, 0};
  scene.constraints = {
      test::joint(JointType::revolute, "hinge", side(scenes::ground, Vector3{}, Vector3{0, 0, 1}),
                  side(0, Vector3{-0.4, 0, 0}, Vector3{0, 0, 1})),
      hold};
  scene.effects = {Gravity<double>{"", {0, -9.81, 0}}};
  return scene;
}

/// A bob that swings on a spherical joint.
Scene bob() {
  Scene scene;
  scene.name = "bob";
  scene.bodies = {test::body("bob", 2, {0.4, 0.5, 0.3}, {1, 0, 0})};
  scene.bodies[0].velocity = {0, 0.3, 0};
  scene.bodies[0].angular_velocity = {0, 0, 0.3};
  scene.constraints = {
      test::joint(JointType::spherical, "pivot", side(scenes::ground), side(0, Vector3{-1, 0, 0}))};
  scene.effects = {Gravity<double>{"", {0, -9.81, 0}}};
  return scene;
}

/// Both scenes side by side, with nothing in common. Gravity becomes a force on each body, since the two may
/// differ.
Scene beside(const Scene& a, const Scene& b) {
  Scene both;
  both.name = a.name + " beside " + b.name;
  int scene_of = 0;
  for (const Scene* one : {&a, &b}) {
    const int bodies = static_cast<int>(both.bodies.size()),
              joints = static_cast<int>(both.constraints.size());
    const std::string prefix = fmt::format("{}_", ++scene_of);
    const auto moved = [&](int body) { return body == scenes::ground ? body : body + bodies; };
    for (scenes::Body body : one->bodies) {
      body.name = prefix + body.name;
      both.bodies.push_back(std::move(body));
    }
    for (scenes::Constraint constraint : one->constraints) {
      constraint.name = prefix + constraint.name;
      constraint.i.body = moved(constraint.i.body);
      constraint.j.body = moved(constraint.j.body);
      both.constraints.push_back(std::move(constraint));
    }
    for (const scenes::Effect& effect : one->effects) {
      if (const auto* g = std::get_if<Gravity<double>>(&effect)) {
        for (std::size_t k = 0; k < one->bodies.size(); ++k) {
          Force<double> weight;
          weight.name = fmt::format("{}weight_{}_{}", prefix, k, both.effects.size());
          weight.body = bodies + static_cast<int>(k);
          for (int axis = 0; axis < 3; ++axis)
            weight.components[axis] = one->bodies[k].mass * g->acceleration[axis];
          both.effects.push_back(weight);
        }
        continue;
      }
      scenes::Effect copy = effect;
      std::visit(
          [&](auto& e) {
            if (!e.name.empty()) e.name = prefix + e.name;
            if constexpr (requires { e.body; }) e.body = moved(e.body);
            if constexpr (requires { e.i.body; }) e.i.body = moved(e.i.body), e.j.body = moved(e.j.body);
            if constexpr (requires { e.angle.joint; }) e.angle.joint += joints;
          },
          copy);
      both.effects.push_back(std::move(copy));
    }
  }
  return both;
}

class EveryMethod : public testing::TestWithParam<integrators::MethodInfo> {};

TEST_P(EveryMethod, LeavesALockedBodyWhereItIs) {
  for (const std::string& formulation : formulations_of(GetParam()))
    for (const Scene& scene :
         {hung_on_a_line(0.1), hung_on({{-1, 0, 0}, {-1, 0, 1}, {-1, 0.1, 2}, {-1, 0.5, -1}}),
          held_lever()}) {
      const Motion motion(scene, options_for(GetParam(), formulation, 0.3));
      const double way = (motion.end().state.pose[0].r - motion.samples[0].state.pose[0].r).norm();
      EXPECT_LE(way, 1e-12) << scene.name << ", " << formulation;
      const SimulationReport& report = motion.report;
      EXPECT_FALSE(energy_is_lost(report.unaccounted_energy, report.largest_kinetic, report.fastest_energy))
          << scene.name << ", " << formulation;
    }
}

TEST_P(EveryMethod, MovesABodyAsItWouldMoveWithoutALockedOneBesideIt) {
  for (const std::string& formulation : formulations_of(GetParam())) {
    const SimulationOptions options = options_for(GetParam(), formulation, 0.3);
    const Motion alone(bob(), options), locked(held_lever(), options),
        both(beside(held_lever(), bob()), options);
    const double apart = (both.end().state.pose[1].r - alone.end().state.pose[0].r).norm();
    EXPECT_LE(apart, options.step ? 1e-9 : 1e-6) << formulation;
    EXPECT_LE(both.report.counters.steps, alone.report.counters.steps + locked.report.counters.steps)
        << formulation;
  }
}

/// A body in an inclined position on three spherical joints, with a torque on it.
Scene twisted() {
  const Eigen::Vector3d axis(0.3, 0.5, -0.8), r(1.1, 0.3, -0.4);
  const auto A = rotation_matrix(exponential_parameters<double>(0.9 * axis.normalized()));
  Scene scene;
  scene.bodies = {test::body("b", 1, {0.1, 0.2, 0.15}, {r[0], r[1], r[2]})};
  scene.bodies[0].orientation = scenes::AxisAngle{{axis[0], axis[1], axis[2]}, 0.9};
  for (const Vector3& s : {Vector3{-0.5, 0.1, -0.3}, Vector3{0.2, 0.3, -0.9}, Vector3{-0.9, 0.7, -0.5}}) {
    const Eigen::Vector3d at = r + A * Eigen::Vector3d(s[0], s[1], s[2]);
    scene.constraints.push_back(test::joint(JointType::spherical,
                                            fmt::format("s{}", scene.constraints.size()),
                                            side(scenes::ground, Vector3{at[0], at[1], at[2]}), side(0, s)));
  }
  Torque<double> torque;
  torque.components = {TimeFunction(1), TimeFunction(2), TimeFunction(-1)};
  scene.effects = {torque};
  return scene;
}

// Rows that are met to rounding say nothing about v', although they would if they were divided by h^2.
TEST(Locked, ATorqueOnABodyIsNoReasonForShortSteps) {
  for (const char* method : {"generalized-alpha", "hht"}) {
    const Motion motion(twisted(), tight("r-omega", method, 1, 1e-8));
    EXPECT_EQ(motion.report.counters.rejected_steps, 0) << method;
    EXPECT_LE(motion.report.phi_dot, 1e-12) << method;
  }
}

INSTANTIATE_TEST_SUITE_P(Locked, EveryMethod, testing::ValuesIn(integrators::methods()),
                         test::method_in_a_name);

/// By how much [m] the bodies of two scenes side by side are not where they are alone.
double apart(const Motion& of_both, const Motion& of_a, const Motion& of_b) {
  double largest = 0;
  const std::size_t bodies_of_a = of_a.end().state.pose.size();
  for (std::size_t k = 0; k < of_both.end().state.pose.size(); ++k) {
    const auto& alone = k < bodies_of_a ? of_a.end().state.pose[k] : of_b.end().state.pose[k - bodies_of_a];
    raise(largest, (of_both.end().state.pose[k].r - alone.r).norm());
  }
  return largest;
}

class Pairs : public testing::TestWithParam<integrators::MethodInfo> {};

// 40 drawn pairs of the catalogue; the formulations take turns
TEST_P(Pairs, OfScenesMoveAsEachAlone) {
  const std::vector<std::string> names{"a01_pendulum",
                                       "adams_revolute_case01",
                                       "simple_pendulum",
                                       "spatial_slider_crank",
                                       "four_bar",
                                       "heavy_top",
                                       "door",
                                       "bricard",
                                       "double_pendulum",
                                       "driven_crank",
                                       "stewart_platform",
                                       "andrews_squeezer",
                                       "n_four_bar_1"};
  const std::string method(GetParam().name);
  const std::vector<std::string> formulations = formulations_of(GetParam());
  std::mt19937 random(20261126);
  for (int pair = 0; pair < 40; ++pair) {
    const Scene a = catalogue_scene(names[random() % names.size()]),
                b = catalogue_scene(names[random() % names.size()]), both = beside(a, b);
    const std::string& formulation = formulations[pair % formulations.size()];
    const auto compare = [&](const SimulationOptions& options, double bound, bool counts_steps) {
      const Motion of_a(a, options), of_b(b, options), of_both(both, options);
      // a change of chart restarts the method for all bodies (docs/limits.md)
      const bool is_restarted = options.step && of_both.report.reframings > 0;
      EXPECT_LE(apart(of_both, of_a, of_b), is_restarted ? 1e-6 : bound) << both.name << ", " << formulation;
      if (!counts_steps) return;
      EXPECT_LE(of_both.report.counters.steps, of_a.report.counters.steps + of_b.report.counters.steps)
          << both.name << ", " << formulation;
    };
    if (GetParam().takes_given_steps) compare(stepping(formulation, method, 0.01, 1e-4), 1e-9, false);
    // these may take more steps (docs/limits.md)
    const bool counts_steps =
        method != "abm" && method != "ida" && !method.starts_with("cvode") && !method.starts_with("arkode");
    if (GetParam().chooses_steps) compare(tight(formulation, method, 0.03, 1e-7), 1e-5, counts_steps);
  }
}

INSTANTIATE_TEST_SUITE_P(SideBySide, Pairs, testing::ValuesIn(integrators::methods()),
                         test::method_in_a_name);

}  // namespace
}  // namespace trivium
