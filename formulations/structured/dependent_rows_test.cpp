/// What the solver along the graph makes of rows that depend on each other, and of states that have no
/// answer.

#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "bodies/numbers/quad.hpp"
#include "formulations/testing/printed_and_structured.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

using scenes::Vector3;
using Polynomial = TimeFunction::Polynomial;
using F = ROmega<double>;

constexpr Vector3 point{0.3, 0.2, 0.1}, axis{1, 0.1, 0.2}, across{0, 0, 1};
constexpr Vector3 slope{0.6, 0, 0.8}, level{0, 1, 0};

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

/// Ranks and which multipliers are unique are those of print, r'' and lambda its solution in quad.
template <class Structured>
void expect_solution_of_quad(const scenes::Scene& scene, double tolerance, const std::string& what) {
  using S = typename Structured::Scalar;
  const auto printed = test::solve_scene<Quad>(scene, {{"r-omega"}, {}}, false);
  ASSERT_EQ(printed.formulations.front().error, "") << what;
  const auto mechanism = make_mechanism<S>(scene);
  AccelerationSolver<Structured> solver(mechanism);
  solver.solve(to_coordinates<Structured>(mechanism, make_state<S>(scene), {}), S(0));
  EXPECT_EQ(solver.rank(), printed.rows.rank) << what;
  EXPECT_EQ(solver.unique(), printed.rows.unique) << what;
  const auto solution = test::solution_of<Quad>(mechanism, solver);
  const PhysicalSolution<Quad>& exact = printed.formulations.front().solution;
  EXPECT_LE(acceleration_distance(printed.rows, solution, exact).all, tolerance) << what;
  EXPECT_LE(lambda_distance(printed.rows, solution.lambda, exact.lambda), tolerance) << what;
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

TEST(NearlyDependentRows, AreToldApartDownToTheToleranceOfRanks) {
  for (const double near : {1e-4, 1e-5, 1e-6, 1e-7})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const scenes::Scene scene = test::random_scene(seed, {.bodies = 1 + static_cast<int>(seed % 5),
                                                            .closings = static_cast<int>(seed / 2 % 3),
                                                            .near_rows = near});
      expect_solution_of_quad<F>(scene, 1e-12 / near, fmt::format("seed {} near {}", seed, near));
    }
}

TEST(NearlyDependentRows, AFourBarNearItsDeadCentreIsRightInFloat) {
  // crank and rocker of 1 m on a coupler of 2 m: folded flat, the four are one line
  for (const double angle : {0.1, 1e-2, 1e-3}) {
    scenes::Scene scene;
    const double c = std::cos(angle), s = std::sin(angle);
    const scenes::AxisAngle turned{{0, 0, 1}, angle};
    for (const auto& [name, x, y] :
         {std::tuple("crank", c / 2, s / 2), {"coupler", c + 1, s}, {"rocker", 2 + c / 2, s / 2}})
      scene.bodies.push_back(test::body(name, 1, {0.1, 0.1, 0.1}, {x, y, 0}));
    scene.bodies[0].orientation = scene.bodies[2].orientation = turned;
    const auto hinge = [&](const std::string& name, int i, const Vector3& P, int j, const Vector3& Q) {
      const Vector3 z{0, 0, 1}, x{1, 0, 0};
      scene.constraints.push_back(
          test::joint(ConstraintType::revolute, name, test::side(i, P, z, x), test::side(j, Q, z, x)));
    };
    hinge("left pivot", scenes::ground, {}, 0, {-0.5, 0, 0});
    hinge("left pin", 0, {0.5, 0, 0}, 1, {-1, 0, 0});
    hinge("right pin", 1, {1, 0, 0}, 2, {0.5, 0, 0});
    hinge("right pivot", scenes::ground, {2, 0, 0}, 2, {-0.5, 0, 0});
    scene.effects = {scenes::Gravity{"", {0.3, -9.81, 0}}};
    expect_solution_of_quad<ROmega<float>>(scene, 1e-6 / angle, fmt::format("{} rad", angle));
  }
}

TEST(NearlyDependentRows, ASecondHingeBesideTheAxisOfTheFirstHoldsTheDoor) {
  for (const double beside : {1e-6, 1e-7}) {
    scenes::Scene scene = pendulum();
    scene.constraints.push_back(scene.constraints[0]);
    scene.constraints[1].name = "second hinge";
    for (scenes::Side* side : {&scene.constraints[1].i, &scene.constraints[1].j}) {
      const double shift = side == &scene.constraints[1].i ? beside : 0;
      side->point = Vector3{point[0] + axis[0], point[1] + axis[1], point[2] + axis[2] + shift};
    }
    expect_solution_of_quad<F>(scene, 1e-12 / beside, fmt::format("{} m beside", beside));
  }
}

/// A block under rows along z at points beside its centre, in torque about y.
scenes::Scene block_on_rows(const std::vector<double>& beside, double moment) {
  scenes::Scene scene;
  scene.bodies = {test::body("block", 1, {moment, moment, moment})};
  for (const double x : beside) {
    scene.constraints.push_back(
        test::joint(ConstraintType::cd, "row " + std::to_string(scene.constraints.size()),
                    test::side(scenes::ground, Vector3{x, 0, 0}), test::side(0, Vector3{x, 0, 0})));
    scene.constraints.back().direction = {0, 0, 1};
  }
  scene.effects = {scenes::Force{"push", 0, {}, {0, 0, 3}, scenes::Frame::global},
                   scenes::Torque{"turn", 0, {0, 0.7, 0}, scenes::Frame::global}};
  return scene;
}

TEST(NearlyDependentRows, AreFoundHoweverWhatIsLeftOfThemLiesToEachOther) {
  for (const double ratio : {1.25, 1.236067977, 2.0, -1.0, 1.618033988})
    for (const double s : {1e-5, 1e-6, 1e-7})
      expect_solution_of_quad<F>(block_on_rows({0.3, 0.3 + ratio * s, 0.3 + s}, 1), 1e-12 / s,
                                 fmt::format("ratio {} of {} m", ratio, s));
}

TEST(NearlyDependentRows, AreJudgedByTheLeversOfTheirOwnAssembly) {
  for (const double far : {1.0, 1e3, 1e6}) {
    scenes::Scene scene = block_on_rows({0.3, 0.3 + 1e-6, -1}, 1);
    scene.bodies.push_back(test::body("elsewhere", 1));
    scene.constraints.push_back(test::joint(ConstraintType::spherical, "far ball",
                                            test::side(scenes::ground, Vector3{far, 0, 0}),
                                            test::side(1, Vector3{far, 0, 0})));
    expect_solution_of_quad<F>(scene, 1e-6, fmt::format("a ball at {} m", far));
  }
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
    scene.effects = {scenes::Force{"pull", 0, {}, {0, 0, 5}, scenes::Frame::global}};
    const auto mechanism = make_mechanism<double>(scene);
    AccelerationSolver<F> solver(mechanism);
    solver.solve(to_coordinates<F>(mechanism, make_state<double>(scene), {}), 0);
    EXPECT_LE(solver.corrections().acceleration, 1) << n;
  }
}

TEST(NearlyDependentRows, TooManyOfThemAreAnErrorThatNamesOne) {
  const scenes::Scene one = block_on_rows({0.3, 0.3 + 1e-6}, 1);
  scenes::Scene scene;
  for (int b = 0; b < 101; ++b) {
    scene.bodies.push_back(test::body("block " + std::to_string(b), 1));
    for (scenes::Constraint row : one.constraints) {
      row.name += " of block " + std::to_string(b);
      row.j.body = b;
      scene.constraints.push_back(row);
    }
    scene.effects.push_back(scenes::Torque{"", b, {0, 0.7, 0}, scenes::Frame::global});
  }
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("row \"row 1 of block 100\""), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("nearly, but not quite"), std::string::npos) << refusal;
}

TEST(NearlyDependentRows, ABodyBetweenHeavyOnesMayBeAsLightAsItWants) {
  // two sliders pulled through a third so light that one row is the negative of the other to rounding
  for (const double light : {1e-9, 1e-15, 1e-20, 1e-32}) {
    scenes::Scene scene;
    for (const auto& [name, mass] : {std::pair("left", 1.0), {"light", light}, {"right", 1.0}}) {
      const int b = static_cast<int>(scene.bodies.size());
      scene.bodies.push_back(test::body(name, mass, {mass, mass, mass}));
      const auto along = [](int body) { return test::side(body, Vector3{}, slope, level); };
      scene.constraints.push_back(test::joint(ConstraintType::translational, "slide " + std::string(name),
                                              along(scenes::ground), along(b)));
    }
    scene.constraints.push_back(cd("left to light", 0, {}, 1, {}));
    scene.constraints.push_back(cd("light to right", 1, {}, 2, {}));
    scene.effects = {scenes::Force{"pull", 0, {}, {0.6, 0, 0.8}, scenes::Frame::global}};
    expect_solution_of_quad<F>(scene, 1e-14, fmt::format("{} kg", light));
  }
}

TEST(RowsOfOneJoint, MayBindTheMotionOfTheParentItself) {
  // both hold the block along the same line, at points of the plate that do not move alike
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
    for (const ConstraintType type : {ConstraintType::translational, ConstraintType::cylindrical}) {
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
      test::joint(ConstraintType::dp1, "no spin", test::vector_side(scenes::ground, {0, 1, 0}),
                  test::vector_side(0, {0, 0, 1}));
  scene.constraints = {test::joint(ConstraintType::spherical, "ball", test::side(scenes::ground, Vector3{}),
                                   test::side(0, Vector3{1, 0, 0})),
                       no_spin};
  scene.effects = {test::gravity()};
  expect_solution_of_quad<F>(scene, 1e-14, "a rod on a ball joint");
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
