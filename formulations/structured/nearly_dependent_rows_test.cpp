/// The structured solver with nearly dependent rows: they are independent, by a small sine.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <tuple>

#include "formulations/structured/testing/dependent_rows_scenes.hpp"
#include "formulations/structured_side_by_side.hpp"

namespace trivium {
namespace {

using scenes::Vector3;
using test::axis, test::block_on_rows, test::cd, test::expect_solution_of_quad, test::level, test::pendulum,
    test::point, test::refusal_of, test::slope;
using F = ROmega<double>;

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
  // crank and rocker of 1 m, coupler and base of 2 m: at the angle 0 all four bars are on one line
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
          test::joint(JointType::revolute, name, test::side(i, P, z, x), test::side(j, Q, z, x)));
    };
    hinge("left pivot", scenes::ground, {}, 0, {-0.5, 0, 0});
    hinge("left pin", 0, {0.5, 0, 0}, 1, {-1, 0, 0});
    hinge("right pin", 1, {1, 0, 0}, 2, {0.5, 0, 0});
    hinge("right pivot", scenes::ground, {2, 0, 0}, 2, {-0.5, 0, 0});
    scene.effects = {Gravity<double>{"", {0.3, -9.81, 0}}};
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

TEST(NearlyDependentRows, LockADoorFromTheSameMisalignmentOnAsInTheDenseAnalysis) {
  for (int percent = 90; percent <= 140; ++percent) {
    const double angle = percent * 1e-10;
    scenes::Scene scene;
    scene.bodies = {test::body("door", 20, {6, 8, 2}, {0.45, 0, 1})};
    const Vector3 tilted{std::sin(angle), 0, std::cos(angle)};
    for (const auto& [name, height, z] : {std::tuple("lower", 0.3, Vector3{0, 0, 1}), {"upper", 1.7, tilted}})
      scene.constraints.push_back(test::joint(JointType::revolute, name,
                                              test::side(scenes::ground, Vector3{0, 0, height}, z),
                                              test::side(0, Vector3{-0.45, 0, height - 1}, z)));
    const auto model = make_model<double>(scene);
    EXPECT_EQ(structured_row_analysis(model).rank, analyse_rows(model).rank) << angle;
  }
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
    scene.constraints.push_back(test::joint(JointType::spherical, "far ball",
                                            test::side(scenes::ground, Vector3{far, 0, 0}),
                                            test::side(1, Vector3{far, 0, 0})));
    expect_solution_of_quad<F>(scene, 1e-6, fmt::format("a ball at {} m", far));
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
    scene.effects.push_back(Torque<double>{"", b, {0, 0.7, 0}, ComponentFrame::global});
  }
  const std::string refusal = refusal_of(scene);
  EXPECT_NE(refusal.find("row \"row 1 of block 100\""), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("are nearly dependent on others"), std::string::npos) << refusal;
}

TEST(NearlyDependentRows, ABodyBetweenHeavyOnesMayBeAsLightAsItWants) {
  // a slider pulls another one through a third, which is so light that its two cd rows are opposite to each
  // other up to rounding
  for (const double light : {1e-9, 1e-15, 1e-20, 1e-32}) {
    scenes::Scene scene;
    for (const auto& [name, mass] : {std::pair("left", 1.0), {"light", light}, {"right", 1.0}}) {
      const int b = static_cast<int>(scene.bodies.size());
      scene.bodies.push_back(test::body(name, mass, {mass, mass, mass}));
      const auto along = [](int body) { return test::side(body, Vector3{}, slope, level); };
      scene.constraints.push_back(test::joint(JointType::translational, "slide " + std::string(name),
                                              along(scenes::ground), along(b)));
    }
    scene.constraints.push_back(cd("left to light", 0, {}, 1, {}));
    scene.constraints.push_back(cd("light to right", 1, {}, 2, {}));
    scene.effects = {
        Force<double>{"pull", 0, trivium::Vector3<double>::Zero(), {0.6, 0, 0.8}, ComponentFrame::global}};
    expect_solution_of_quad<F>(scene, 1e-14, fmt::format("{} kg", light));
  }
}

}  // namespace
}  // namespace trivium
