/// A batch of states solves each of them.

#include "bodies/batch_states.hpp"

#include "bodies/testing.hpp"
#include "formulations/acceleration_solver.hpp"
#include "formulations/r_epsilon.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "formulations/test_mechanisms.hpp"
#include "scenes/generators.hpp"
#include "scenes/mechanism_cast.hpp"

namespace trivium {
namespace {

using Four = Batch<double, 4>;

/// States that differ in how the bodies turn and move, the poses being those of the scene.
std::vector<MechanismState<double>> ensemble(const scenes::Scene& scene) {
  test::Random random(5);
  std::vector<MechanismState<double>> states(Four::lanes, make_state<double>(scene));
  for (auto& state : states)
    for (auto& twist : state.twist) twist.omega_bar += random.vector<double, 3>();
  return states;
}

template <template <class> class F>
void expect_lanes_are_the_states(const scenes::Scene& scene) {
  const auto mechanism = make_mechanism<double>(scene);
  const auto in_lanes = mechanism_cast<Four>(mechanism);
  const auto states = ensemble(scene);
  AccelerationSolver<F<double>> one(mechanism);
  AccelerationSolver<F<Four>> four(in_lanes);
  const auto all = pack<double, Four::lanes>(std::span<const MechanismState<double>, Four::lanes>(states));
  four.solve(to_coordinates<F<Four>>(in_lanes, all, {}), all.t);
  for (int k = 0; k < Four::lanes; ++k) {
    one.solve(to_coordinates<F<double>>(mechanism, states[k], {}), 0);
    for (int b = 0; b < mechanism.nb(); ++b) {
      const double size = one.r_ddot(b).norm() + one.omega_bar_dot(b).norm();
      EXPECT_LE((lane_of(four.r_ddot(b), k) - one.r_ddot(b)).norm(), 1e-12 * size);
      EXPECT_LE((lane_of(four.omega_bar_dot(b), k) - one.omega_bar_dot(b)).norm(), 1e-12 * size);
    }
    EXPECT_LE((lane_of(four.lambda(), k) - one.lambda()).norm(), 1e-12 * one.lambda().norm());
  }
}

TEST(Batch, LanesAreTheStatesOneByOne) {
  expect_lanes_are_the_states<ROmega>(scenes::chain(7));
  expect_lanes_are_the_states<RP>(scenes::chain(7));
  expect_lanes_are_the_states<REpsilon>(scenes::chain(7));
  expect_lanes_are_the_states<ROmega>(scenes::ladder(3));
  expect_lanes_are_the_states<ROmega>(test::random_scene(8, {.bodies = 4, .closings = 1}));
}

TEST(Batch, RefusesABranchOnWhichItsLanesDisagree) {
  Four x(1.0);
  x.set(2, -1);
  EXPECT_THROW(static_cast<void>(x > Four(0) ? 1 : 2), MixedLanes);
  EXPECT_TRUE(abs(x) == Four(1));
  EXPECT_EQ(select(x > Four(0), Four(3), Four(4))[2], 4);
}

}  // namespace
}  // namespace trivium
