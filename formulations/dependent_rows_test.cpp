/// What the solver along the graph makes of rows that depend on each other, and of states that have no
/// answer.

#include <cmath>
#include <limits>
#include <string>

#include "formulations/solved_twice.hpp"
#include "scenes/generators.hpp"
#include "scenes/test_scenes.hpp"

namespace trivium {
namespace {

using scenes::ConstraintType;
using scenes::Vector3;
using Polynomial = TimeFunction::Polynomial;
using F = ROmega<double>;

constexpr Vector3 point{0.3, 0.2, 0.1}, axis{1, 0.1, 0.2}, across{0, 0, 1};

/// A body on a revolute to the ground.
scenes::Scene pendulum() {
  scenes::Scene scene;
  scene.bodies = {test::body("rod", 1, {1, 1.1, 1.2})};
  scene.constraints = {test::joint(ConstraintType::revolute, "hinge",
                                   test::side(scenes::ground, point, axis, across),
                                   test::side(0, point, axis, across))};
  scene.effects = {test::gravity()};
  return scene;
}
scenes::Constraint driver(const std::string& name, const Vector3& about, const Vector3& x,
                          const TimeFunction& angle) {
  scenes::Constraint c = test::joint(ConstraintType::rotation_driver, name,
                                     test::side(scenes::ground, {}, about, x), test::side(0, {}, about, x));
  c.angle = angle;
  return c;
}
scenes::Constraint cd(const std::string& name, int i, const Vector3& s_i, int j, const Vector3& s_j,
                      const TimeFunction& f = 0) {
  scenes::Constraint c = test::joint(ConstraintType::cd, name, test::side(i, s_i), test::side(j, s_j));
  c.direction = {0.6, 0, 0.8};
  c.f = f;
  return c;
}

std::string refusal_of(const scenes::Scene& scene) {
  const auto mechanism = make_mechanism<double>(scene);
  AccelerationSolver<F> solver(mechanism);
  try {
    solver.solve(to_coordinates<F>(mechanism, make_state<double>(scene), {}), 0);
  } catch (const ModelError& error) {
    EXPECT_TRUE(std::isnan(solver.r_ddot(0)[0])) << "an answer after an error";
    return error.what();
  }
  return "";
}

TEST(DependentRows, DriversThatAgreeShareTheTorque) {
  scenes::Scene scene = pendulum();
  for (const char* name : {"motor", "second motor"})
    scene.constraints.push_back(driver(name, axis, across, Polynomial{{0, 0, 0.5}}));
  test::expect_agreement<F>(scene, "two drivers of one motion");
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
  // v_i . u_j = v_i . z_hinge: zero however the hinge turns
  scene.constraints.push_back(driver("motor", {-0.12, 0.26, 0.47}, axis, 0));
  test::expect_agreement<F>(scene, "a driver about an axis across the hinge's");
  scene.constraints.back() = driver("motor", {1, 1, 0}, across, 0);
  test::expect_agreement<F>(scene, "a driver about an axis aslant the hinge's");
}

TEST(DependentRows, APointOfAWeldHeldToItselfAddsNothing) {
  // whatever the two bodies do, so that the columns cancel on the way up and only their rounding goes on
  scenes::Scene scene = pendulum();
  scene.bodies.push_back(test::body("welded", 1, {1, 1, 1}, {0.1, 0.7, -0.4}));
  const auto at = [&](const Vector3& P) {
    const Vector3& r = scene.bodies[1].position;
    return Vector3{P[0] - r[0], P[1] - r[1], P[2] - r[2]};
  };
  scene.constraints.push_back(test::joint(ConstraintType::fixed, "weld", test::side(0, point, axis, across),
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

TEST(DependentRows, ARowLostToRoundingIsAnErrorEvenWhereNothingMoves) {
  // two sliders pulled through a third so light that one row is the negative of the other to rounding
  scenes::Scene scene;
  for (const auto& [name, mass] :
       {std::pair("left", 1.0), std::pair("light", 1e-15), std::pair("right", 1.0)}) {
    const int b = static_cast<int>(scene.bodies.size());
    scene.bodies.push_back(test::body(name, mass, {mass, mass, mass}));
    const auto along = [](int body) {
      return test::side(body, Vector3{}, Vector3{0.6, 0, 0.8}, Vector3{0, 1, 0});
    };
    scene.constraints.push_back(test::joint(ConstraintType::translational, "slide " + std::string(name),
                                            along(scenes::ground), along(b)));
  }
  scene.constraints.push_back(cd("left to light", 0, {}, 1, {}));
  scene.constraints.push_back(cd("light to right", 1, {}, 2, {}));
  scene.effects = {scenes::Force{"pull", 0, {}, {0.6, 0, 0.8}, scenes::Frame::global}};
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("light"), std::string::npos) << refusal;
  for (scenes::Body& body : scene.bodies) body.mass = 1;
  EXPECT_EQ(refusal_of(scene), "");
}

TEST(DependentRows, VelocitiesMayMissTheirRowsByWhatAnIntegratorLeaves) {
  // rods that turn alike, so that no angular acceleration tells how fast
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
  scene.effects = {scenes::Force{"blow", 1, {}, {1e9, 0, 0}, scenes::Frame::global}};
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("second guide"), std::string::npos) << refusal;
}

TEST(NoAnswer, AJointWhoseAxesHaveFallenTogetherIsAnErrorThatNamesItsBody) {
  scenes::Scene scene = pendulum();
  scene.constraints[0].type = ConstraintType::universal;  // wants its axes perpendicular
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("body \"rod\""), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("depend on each other"), std::string::npos) << refusal;
}

TEST(NoAnswer, AFreeTurnWithoutInertiaIsAnErrorThatNamesItsBody) {
  // a rod without a moment about the axis that a cylindrical leaves free, which is none of the body's own
  scenes::Scene scene;
  scene.bodies = {test::body("rod", 1)};
  const Vector3 along{0.3, 0.5, 0.7};
  const double length2 = 0.3 * 0.3 + 0.5 * 0.5 + 0.7 * 0.7;
  scenes::Matrix3 inertia;
  for (int m = 0; m < 3; ++m)
    for (int n = 0; n < 3; ++n) inertia[m][n] = (m == n ? 1 : 0) - along[m] * along[n] / length2;
  scene.bodies[0].inertia = inertia;
  scene.constraints = {test::joint(ConstraintType::cylindrical, "sleeve",
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
    EXPECT_NE(std::string(error.what()).find("body \"rod\" at t = 0: its state is not finite"),
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
