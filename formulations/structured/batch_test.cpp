/// Each lane of a batch gives the solution that its state gives alone.

#include "mechanism/state_batch.hpp"
#include "scenes/make_mechanism.hpp"

#include <gtest/gtest.h>

#include "bodies/rotations/so3.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/equations_of_motion_impl.hpp"
#include "formulations/r_epsilon.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "mechanism/mechanism_batch.hpp"
#include "scenes/generators.hpp"

namespace trivium {
namespace {

using Four = Batch<double, 4>;

/// One scene per lane; all have the same structure.
using Scenes = std::vector<scenes::Scene>;

/// Scenes that differ in the velocities of the mechanism, each scaled by its own factor.
Scenes moving(const scenes::Scene& scene) {
  test::Random random(5);
  Scenes all(Four::lanes, scene);
  for (scenes::Scene& one : all) {
    const double faster = 1 + random.uniform();
    for (scenes::Body& body : one.bodies)
      for (auto* v : {&body.velocity, &body.angular_velocity})
        for (double& x : *v) x *= faster;
  }
  return all;
}

template <template <class> class F>
void expect_lanes_are_the_scenes(const Scenes& all, double time_step = 0) {
  std::vector<Mechanism<double>> mechanisms;
  std::vector<MechanismState<double>> states;
  for (const scenes::Scene& scene : all) {
    mechanisms.push_back(make_mechanism<double>(scene));
    states.push_back(make_state<double>(scene, time_step * static_cast<double>(states.size())));
  }
  const auto in_lanes =
      pack<double, Four::lanes>(std::span<const Mechanism<double>, Four::lanes>(mechanisms));
  const auto state = pack<double, Four::lanes>(std::span<const MechanismState<double>, Four::lanes>(states));
  AccelerationSolver<F<Four>> four(in_lanes);
  four.solve(to_coordinates<F<Four>>(in_lanes, state, {}), state.t);
  for (int k = 0; k < Four::lanes; ++k) {
    const Mechanism<double>& mechanism = mechanisms[k];
    AccelerationSolver<F<double>> one(mechanism);
    one.solve(to_coordinates<F<double>>(mechanism, states[k], {}), states[k].t);
    for (int b = 0; b < mechanism.nb(); ++b) {
      const double size = one.r_ddot(b).norm() + one.omega_bar_dot(b).norm();
      EXPECT_LE((lane_of(four.r_ddot(b), k) - one.r_ddot(b)).norm(), 1e-12 * size);
      EXPECT_LE((lane_of(four.omega_bar_dot(b), k) - one.omega_bar_dot(b)).norm(), 1e-12 * size);
    }
    EXPECT_LE((lane_of(four.lambda(), k) - one.lambda()).norm(), 1e-12 * one.lambda().norm());
  }
}

TEST(Batch, LanesAreTheStatesOneByOne) {
  expect_lanes_are_the_scenes<ROmega>(moving(scenes::chain(7)));
  expect_lanes_are_the_scenes<RP>(moving(scenes::chain(7)));
  expect_lanes_are_the_scenes<REpsilon>(moving(scenes::chain(7)));
  expect_lanes_are_the_scenes<ROmega>(moving(scenes::ladder(3)));
  expect_lanes_are_the_scenes<ROmega>(moving(test::random_scene(8, {.bodies = 4, .closings = 1})));
}

TEST(Batch, EachLaneHasItsTime) {
  expect_lanes_are_the_scenes<ROmega>(
      moving(test::random_scene(8, {.bodies = 3, .closings = 1, .driven = true})), 0.1);
}

/// The scene, in each lane with other masses and another rotation about the global origin; equal gravity.
Scenes turned(const scenes::Scene& scene) {
  test::Random random(6);
  Scenes all(Four::lanes, scene);
  for (scenes::Scene& one : all) {
    const Vector4<double> p = random.euler_parameters<double>();
    const auto turn = [A = rotation_matrix(p)](scenes::Vector3& v) {
      const Vector3<double> w = A * Vector3<double>(v[0], v[1], v[2]);
      v = {w[0], w[1], w[2]};
    };
    for (scenes::Body& body : one.bodies) {
      const double heavier = 2 + random.uniform();
      body.mass *= heavier;
      for (double& J : std::get<scenes::Vector3>(body.inertia)) J *= heavier;
      turn(body.position);
      turn(body.velocity);
      const Matrix3<double> A =
          rotation_matrix(p) * rotation_matrix(euler_parameters_of<double>(body.orientation));
      const Vector4<double> now = euler_parameters<double>(A);
      body.orientation = scenes::EulerParameters{{now[0], now[1], now[2], now[3]}};
    }
    for (scenes::Constraint& c : one.constraints) {
      turn(c.direction);
      for (scenes::Side* side : {&c.i, &c.j})
        for (auto* v : {&side->point, &side->vector, &side->axis, &side->x})
          if (side->body == scenes::ground && *v) turn(**v);
    }
  }
  return all;
}

TEST(Batch, LanesMayDifferInPosesAndInMasses) {
  const scenes::Scene loop = test::random_scene(8, {.bodies = 4, .closings = 1});
  expect_lanes_are_the_scenes<ROmega>(turned(scenes::chain(7)));
  expect_lanes_are_the_scenes<RP>(turned(loop));
  expect_lanes_are_the_scenes<REpsilon>(turned(scenes::chain(7)));
}

TEST(Batch, LanesMayFloatFreely) {
  scenes::Scene afloat = scenes::chain(3);
  afloat.constraints.erase(afloat.constraints.begin());
  expect_lanes_are_the_scenes<ROmega>(turned(afloat));
  for (const auto type : {JointType::cylindrical, JointType::planar}) {
    scenes::Scene sliding = scenes::chain(3);
    sliding.constraints[0].type = type;
    expect_lanes_are_the_scenes<RP>(turned(sliding));
  }
}

TEST(Batch, LanesMayNotDifferInMoreThanNumbers) {
  Scenes all(Four::lanes, test::random_scene(8, {.bodies = 3, .closings = 1}));
  const auto refusal = [&] {
    std::vector<Mechanism<double>> mechanisms;
    for (const scenes::Scene& scene : all) mechanisms.push_back(make_mechanism<double>(scene));
    try {
      pack<double, Four::lanes>(std::span<const Mechanism<double>, Four::lanes>(mechanisms));
    } catch (const ModelError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(), "");
  all[2].constraints.back().f = 0.25;
  EXPECT_NE(refusal().find("mechanism 3 of a batch"), std::string::npos) << refusal();
  all[2] = all[0];
  all[1].constraints.pop_back();
  EXPECT_NE(refusal().find("mechanism 2 of a batch"), std::string::npos) << refusal();
  all[1] = all[0];
  all[3].rank_tolerance = 1e-6;
  EXPECT_NE(refusal().find("mechanism 4 of a batch"), std::string::npos) << refusal();
}

TEST(Batch, RefusesABranchOnWhichItsLanesDisagree) {
  Four x(1.0);
  x.set(2, -1);
  EXPECT_THROW(static_cast<void>(x > Four(0) ? 1 : 2), MixedLanes);
  EXPECT_TRUE(abs(x) == Four(1));
  EXPECT_EQ(select(x > Four(0), Four(3), Four(4))[2], 4);
}

TEST(Batch, ARowThatStandsInEachLaneByAnotherColumnDoesNotPassForDependent) {
  // the row is along y in two lanes and along x in the other two: no column is a pivot in all lanes
  Four x(1.0), y(0.0);
  for (int lane : {0, 1}) {
    x.set(lane, 0);
    y.set(lane, 1);
  }
  BodyBlock<Four> H;
  for (int k = 0; k < 3; ++k) H.rr(k, k) = H.xx(k, k) = Four(1);
  BodyColumns<Four> C;
  C.r(0, 0) = x;
  C.r(1, 0) = y;
  const PointRows<Four> none;
  std::array<bool, 6> dependent{};
  GeneralLink<Four> link;
  const BodyColumns<Four> parent;
  EXPECT_THROW(link.factor(H, {none, C, parent, 1}, nullptr, DependentRows::detect, dependent), MixedLanes);
}

TEST(Batch, TheWorstLaneIsTheOneThatIsNotANumber) {
  Four x(1.0);
  x.set(1, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(std::isnan(largest_lane(x)));
}

TEST(Batch, TheLargerOfTwoIsTheOneThatIsNotANumberLaneByLane) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Four x(1.0), y(2.0);
  x.set(1, nan);
  y.set(2, nan);
  x.set(3, 3.0);
  for (const Four& found : {larger(x, y), larger(y, x)}) {
    EXPECT_EQ(found[0], 2);
    EXPECT_TRUE(std::isnan(found[1]));
    EXPECT_TRUE(std::isnan(found[2]));
    EXPECT_EQ(found[3], 3);
  }
  EXPECT_TRUE(std::isnan(larger(nan, 1.0)));
  EXPECT_TRUE(std::isnan(larger(1.0, nan)));
}

}  // namespace
}  // namespace trivium
