#pragma once
/// Support of the tests: small scenes with dependent or nearly dependent rows, and the comparison of their
/// structured solution with the printed system in quad.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bodies/numbers/quad.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "formulations/testing/printed_and_structured.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium::test {

inline constexpr scenes::Vector3 point{0.3, 0.2, 0.1}, axis{1, 0.1, 0.2}, across{0, 0, 1};
inline constexpr scenes::Vector3 slope{0.6, 0, 0.8}, level{0, 1, 0};

/// A body that a revolute connects to the ground.
inline scenes::Scene pendulum() {
  scenes::Scene scene;
  scene.bodies = {body("rod", 1, {1, 1.1, 1.2})};
  scene.constraints = {joint(JointType::revolute, "hinge", side(scenes::ground, point, axis, across),
                             side(0, point, axis, across))};
  scene.effects = {gravity()};
  return scene;
}
inline scenes::Constraint driver(const std::string& name, const scenes::Vector3& about,
                                 const scenes::Vector3& x, const TimeFunction& angle) {
  scenes::Constraint c =
      joint(JointType::rotation_driver, name, side(scenes::ground, {}, about, x), side(0, {}, about, x));
  c.angle = angle;
  return c;
}
inline scenes::Constraint cd(const std::string& name, int i, const scenes::Vector3& s_i, int j,
                             const scenes::Vector3& s_j, const TimeFunction& f = 0) {
  scenes::Constraint c = joint(basic_type<CD>, name, side(i, s_i), side(j, s_j));
  c.direction = {0.6, 0, 0.8};
  c.f = f;
  return c;
}

/// Expects the rank and the unique multipliers of the printed system, and its r'' and lambda in quad.
template <class Structured>
void expect_solution_of_quad(const scenes::Scene& scene, double tolerance, const std::string& what) {
  using S = typename Structured::Scalar;
  const auto printed = solve_scene<Quad>(scene, {{"r-omega"}, {}}, false);
  ASSERT_EQ(printed.formulations.front().error, "") << what;
  const auto mechanism = make_mechanism<S>(scene);
  AccelerationSolver<Structured> solver(mechanism);
  solver.solve(to_coordinates<Structured>(mechanism, make_state<S>(scene), {}), S(0));
  EXPECT_EQ(solver.rank(), printed.rows.rank) << what;
  EXPECT_EQ(solver.unique(), printed.rows.unique) << what;
  const auto solution = solution_of<Quad>(mechanism, solver);
  const PhysicalSolution<Quad>& exact = printed.formulations.front().solution;
  EXPECT_LE(acceleration_distance(printed.rows, solution, exact).all, tolerance) << what;
  EXPECT_LE(lambda_distance(printed.rows, solution.lambda, exact.lambda), tolerance) << what;
}

/// The message of the error that r-omega throws; empty if there is none. After an error all results must be
/// NaN.
inline std::string refusal_of(const scenes::Scene& scene) {
  const auto mechanism = make_mechanism<double>(scene);
  AccelerationSolver<ROmega<double>> solver(mechanism);
  try {
    solver.solve(to_coordinates<ROmega<double>>(mechanism, make_state<double>(scene), {}), 0);
  } catch (const ModelError& error) {
    EXPECT_TRUE(std::isnan(solver.r_ddot(0)[0])) << "an answer after an error";
    return error.what();
  }
  return "";
}

/// A block with cd rows along z at the points x = beside [m] on its x axis, under a force along z and a
/// torque about y.
inline scenes::Scene block_on_rows(const std::vector<double>& beside, double moment) {
  scenes::Scene scene;
  scene.bodies = {body("block", 1, {moment, moment, moment})};
  for (const double x : beside) {
    scene.constraints.push_back(joint(basic_type<CD>, "row " + std::to_string(scene.constraints.size()),
                                      side(scenes::ground, scenes::Vector3{x, 0, 0}),
                                      side(0, scenes::Vector3{x, 0, 0})));
    scene.constraints.back().direction = {0, 0, 1};
  }
  scene.effects = {
      Force<double>{"push", 0, trivium::Vector3<double>::Zero(), {0, 0, 3}, ComponentFrame::global},
      Torque<double>{"turn", 0, {0, 0.7, 0}, ComponentFrame::global}};
  return scene;
}

}  // namespace trivium::test
