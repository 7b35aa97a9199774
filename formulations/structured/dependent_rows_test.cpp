/// The structured solver with rows that depend on each other, and with states that have no solution.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "formulations/structured/testing/dependent_rows_scenes.hpp"
#include "scenes/generators.hpp"

namespace trivium {
namespace {

using scenes::Vector3;
using test::across, test::axis, test::block_on_rows, test::cd, test::driver, test::expect_solution_of_quad,
    test::level, test::pendulum, test::point, test::refusal_of, test::slope;
using Polynomial = TimeFunction::Polynomial;
using F = ROmega<double>;

TEST(DependentRows, DriversThatAgreeShareTheTorque) {
  scenes::Scene scene = pendulum();
  for (const char* name : {"motor", "second motor"})
    scene.constraints.push_back(driver(name, axis, across, Polynomial{{0, 0, 0.5}}));
  test::expect_agreement<F>(scene, "two drivers of one motion");
}

/// Motions use DependentRows::detect_near_singular, where candidates are not examined and no levers are
/// measured. unique() must be right even so.
TEST(DependentRows, UniqueMultipliersAreToldHoweverTheRowsWereFound) {
  scenes::Scene scene = pendulum();
  for (const char* name : {"motor", "second motor"})
    scene.constraints.push_back(driver(name, axis, across, Polynomial{{0, 0, 0.5}}));
  const auto [mechanism, state] = make_model<double>(scene);
  const auto bodies = to_coordinates<F>(mechanism, state, {});
  AccelerationSolver<F> strict(mechanism), along(mechanism);
  strict.solve(bodies, state.t);
  along.solve(bodies, state.t, Refinement::as_needed, DependentRows::detect_near_singular);
  const std::vector<bool> unique = along.unique();
  EXPECT_EQ(unique, strict.unique());
  EXPECT_EQ(std::count(unique.begin(), unique.end(), false), 2);
}

TEST(DependentRows, AMultiplierOfARowWithoutGradientIsNotUnique) {
  scenes::Scene scene = pendulum();
  // d . d between points that coincide
  scene.constraints.push_back(
      test::joint(basic_type<D>, "nothing", test::side(scenes::ground, point), test::side(0, point)));
  test::expect_agreement<F>(scene, "a row without gradient beside a hinge");
}

TEST(DependentRows, DriversThatContradictAreAnErrorThatNamesOne) {
  scenes::Scene scene = pendulum();
  scene.constraints.push_back(driver("motor", axis, across, Polynomial{{0, 0, 0.5}}));
  scene.constraints.push_back(driver("second motor", axis, across, Polynomial{{0, 0, 0.50001}}));
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("second motor"), std::string::npos) << refusal;
}

TEST(DependentRows, RowsOfOneEdgeThatContradictAreAnErrorThatNamesOne) {
  scenes::Scene scene;
  scene.bodies = {test::body("block", 2)};
  scene.constraints = {cd("guide", scenes::ground, {}, 0, {}),
                       cd("second guide", scenes::ground, {}, 0, {}, Polynomial{{0, 0, 1}})};
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("second guide"), std::string::npos) << refusal;
}

TEST(DependentRows, ADriverAcrossItsRevoluteIsRankedLikeAnyRow) {
  scenes::Scene scene = pendulum();
  // v_i . u_j = v_i . z_hinge = 0 at any angle of the hinge, so the driver's row is redundant
  scene.constraints.push_back(driver("motor", {-0.12, 0.26, 0.47}, axis, 0));
  test::expect_agreement<F>(scene, "a driver about an axis across the hinge's");
  scene.constraints.back() = driver("motor", {1, 1, 0}, across, 0);
  test::expect_agreement<F>(scene, "a driver about an axis aslant the hinge's");
}

TEST(DependentRows, APointOfAWeldHeldToItselfAddsNothing) {
  // the row holds for all motions of the two bodies; its columns cancel at the weld, and only their rounding
  // error is passed to the parent
  scenes::Scene scene = pendulum();
  scene.bodies.push_back(test::body("welded", 1, {1, 1, 1}, {0.1, 0.7, -0.4}));
  const auto at = [&](const Vector3& P) {
    const Vector3& r = scene.bodies[1].position;
    return Vector3{P[0] - r[0], P[1] - r[1], P[2] - r[2]};
  };
  scene.constraints.push_back(test::joint(JointType::fixed, "weld", test::side(0, point, axis, across),
                                          test::side(1, at(point), axis, across)));
  const Vector3 P{0.7, 1.1, -0.3};
  scene.constraints.push_back(cd("pin", 0, P, 1, at(P)));
  test::expect_agreement<F>(scene, "a cd row between coincident points of welded bodies");
}

TEST(DependentRows, GuidesOfTheGroundNeedNotShareAPointThere) {
  scenes::Scene scene;
  scene.bodies = {test::body("block", 2)};
  scene.effects = {test::gravity()};
  scene.constraints = {cd("guide", scenes::ground, {}, 0, {}),
                       cd("second guide", scenes::ground, {0.8, 3, -0.6}, 0, {})};
  test::expect_agreement<F>(scene, "two guides in one plane");
}

TEST(DependentRows, VelocitiesMayMissTheirRowsByWhatAnIntegratorLeaves) {
  // the rods rotate at the same rate, so no angular acceleration shows the size of the terms omega^2
  for (const double e : {2e-12, 1e-10, 1e-8}) {
    scenes::Scene scene = scenes::ladder(3);
    scene.bodies[4].angular_velocity[0] += e;
    EXPECT_LE(test::SolvedTwice<F>(scene).accelerations_apart(), 100 * e);
  }
}

TEST(DependentRows, AForceElsewhereHidesNoContradiction) {
  scenes::Scene scene;
  scene.bodies = {test::body("block", 2), test::body("shot", 1)};
  scene.constraints = {cd("guide", scenes::ground, {}, 0, {}, Polynomial{{0, 0, 0.5}}),
                       cd("second guide", scenes::ground, {}, 0, {}, Polynomial{{0, 0, 1}})};
  scene.effects = {
      Force<double>{"blow", 1, trivium::Vector3<double>::Zero(), {1e9, 0, 0}, ComponentFrame::global}};
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("second guide"), std::string::npos) << refusal;
}

TEST(DependentRows, MayMissEachOtherByWhatAssemblyLeavesHoweverLightTheirMotion) {
  for (const double moment : {1.0, 1e-2, 1e-4, 1e-6})
    expect_solution_of_quad<F>(block_on_rows({std::sqrt(moment), std::sqrt(moment) + 1e-9, 1}, moment), 1e-9,
                               fmt::format("{} kg m^2", moment));
}

TEST(DependentRows, ShareOfARowInAnotherIsSeenDownToTheToleranceOfRanks) {
  scenes::Scene scene = block_on_rows({0, 0, 0}, 1);
  for (const double share : {1.0, 1e-3, 1e-6, 1e-7}) {
    scene.constraints[1].direction = {0, 1, 0};
    scene.constraints[2].direction = {0, share, 1};
    expect_solution_of_quad<F>(scene, 1e-12, fmt::format("a share of {}", share));
  }
}

TEST(DependentRows, ForcesInBalanceLeaveNoMoreThanAllToCorrect) {
  for (int n : {2, 5}) {
    scenes::Scene scene = scenes::ladder(n);
    for (scenes::Body& body : scene.bodies) body.velocity = body.angular_velocity = {};
    scene.effects = {
        Force<double>{"pull", 0, trivium::Vector3<double>::Zero(), {0, 0, 5}, ComponentFrame::global}};
    const auto mechanism = make_mechanism<double>(scene);
    AccelerationSolver<F> solver(mechanism);
    solver.solve(to_coordinates<F>(mechanism, make_state<double>(scene), {}), 0);
    EXPECT_LE(solver.corrections().acceleration, 1) << n;
  }
}

TEST(RowsOfOneJoint, MayBindTheMotionOfTheParentItself) {
  // on the block the two guides are the same row, but on the plate they act at different points: together
  // they constrain the plate's own motion
  scenes::Scene scene = pendulum();
  scene.bodies.push_back(test::body("block", 1, {1, 1.1, 1.2}, {0.1, 0.7, -0.4}));
  scene.effects = {test::gravity()};
  scene.constraints.push_back(cd("guide", 0, {0.1, 0.7, -0.4}, 1, {}));
  scene.constraints.push_back(cd("second guide", 0, {0.5, 0.9, -0.7}, 1, {}));
  expect_solution_of_quad<F>(scene, 1e-13, "a plate on a hinge");
  scene.constraints.erase(scene.constraints.begin());
  expect_solution_of_quad<F>(scene, 1e-13, "a plate in free fall");
}

TEST(RowsOfOneJoint, HoldABodyOfHardlyAnyInertia) {
  for (const double J : {1e-12, 1e-15, 1e-18, 1e-30})
    for (const ConstraintType type : {JointType::translational, JointType::cylindrical}) {
      scenes::Scene scene;
      scene.bodies = {test::body("collar", 1, {J, J, J})};
      const auto along = [](int body) { return test::side(body, point, slope, level); };
      scene.constraints = {test::joint(type, "slide", along(scenes::ground), along(0))};
      scene.effects = {test::gravity()};
      expect_solution_of_quad<F>(scene, 1e-14, fmt::format("{} kg m^2", J));
    }
}

TEST(RowsOfOneJoint, HoldASpinWithoutInertiaTogether) {
  scenes::Scene scene;
  scene.bodies = {test::body("rod", 1, {0, 1, 1}, {-1, 0, 0})};
  const scenes::Constraint no_spin =
      test::joint(basic_type<DP1>, "no spin", test::vector_side(scenes::ground, {0, 1, 0}),
                  test::vector_side(0, {0, 0, 1}));
  scene.constraints = {test::joint(JointType::spherical, "ball", test::side(scenes::ground, Vector3{}),
                                   test::side(0, Vector3{1, 0, 0})),
                       no_spin};
  scene.effects = {test::gravity()};
  expect_solution_of_quad<F>(scene, 1e-14, "a rod on a ball joint");
}

TEST(NoAnswer, AJointWhoseAxesHaveFallenTogetherIsAnErrorThatNamesItsBody) {
  scenes::Scene scene = pendulum();
  scene.constraints[0].type = JointType::universal;  // its axes must be perpendicular, here they are equal
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("body \"rod\""), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("depend on each other"), std::string::npos) << refusal;
}

TEST(NoAnswer, AFreeTurnWithoutInertiaIsAnErrorThatNamesItsBody) {
  // a rod without a moment of inertia about the axis that the cylindrical joint leaves free; the axis is not
  // along a body axis, so no diagonal entry of the inertia shows this
  scenes::Scene scene;
  scene.bodies = {test::body("rod", 1)};
  const Vector3 along{0.3, 0.5, 0.7};
  const double length2 = 0.3 * 0.3 + 0.5 * 0.5 + 0.7 * 0.7;
  scenes::Matrix3 inertia;
  for (int m = 0; m < 3; ++m)
    for (int n = 0; n < 3; ++n) inertia[m][n] = (m == n ? 1 : 0) - along[m] * along[n] / length2;
  scene.bodies[0].inertia = inertia;
  scene.constraints = {test::joint(JointType::cylindrical, "sleeve",
                                   test::side(scenes::ground, Vector3{}, along),
                                   test::side(0, Vector3{}, along))};
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("body \"rod\""), std::string::npos) << refusal;
}

TEST(NoAnswer, AStateThatIsNotFiniteIsAnErrorThatNamesItsBody) {
  const scenes::Scene scene = pendulum();
  const auto mechanism = make_mechanism<double>(scene);
  auto state = to_coordinates<F>(mechanism, make_state<double>(scene), {});
  state[0].q.A(1, 1) = std::numeric_limits<double>::quiet_NaN();
  AccelerationSolver<F> solver(mechanism);
  try {
    solver.solve(state, 0);
    ADD_FAILURE() << solver.lambda().transpose();
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("body \"rod\" at t = 0: the state of the body is not finite"),
              std::string::npos)
        << error.what();
  }
}

TEST(NoAnswer, ANaNDoesNotOutliveItsState) {
  scenes::Scene scene;
  scene.bodies = {test::body("free", 2)};
  scene.effects = {test::gravity()};
  const auto mechanism = make_mechanism<double>(scene);
  const auto good = to_coordinates<F>(mechanism, make_state<double>(scene), {});
  auto bad = good;
  bad[0].q.omega_bar[0] = std::numeric_limits<double>::quiet_NaN();
  AccelerationSolver<F> solver(mechanism);
  solver.solve(bad, 0);
  EXPECT_TRUE(std::isnan(solver.omega_bar_dot(0)[0]));
  solver.solve(good, 0);
  EXPECT_EQ(solver.r_ddot(0)[2], -9.81);
  EXPECT_EQ(solver.omega_bar_dot(0).norm(), 0);
}

}  // namespace
}  // namespace trivium
