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

extern template class GraphSolver<Batch<double, 4>>;  // graph_solver_batch.cpp

namespace {

using Four = Batch<double, 4>;

/// States that differ in how fast the mechanism moves, the poses being those of the scene.
std::vector<MechanismState<double>> ensemble(const scenes::Scene& scene) {
  test::Random random(5);
  std::vector<MechanismState<double>> states(Four::lanes, make_state<double>(scene));
  for (auto& state : states) {
    const double faster = 1 + random.uniform();
    for (auto& twist : state.twist) {
      twist.r_dot *= faster;
      twist.omega_bar *= faster;
    }
  }
  return states;
}

template <template <class> class F>
void expect_lanes_are_the_states(const scenes::Scene& scene, double time_step = 0) {
  const auto mechanism = make_mechanism<double>(scene);
  const auto in_lanes = mechanism_cast<Four>(mechanism);
  auto states = ensemble(scene);
  for (int k = 0; k < Four::lanes; ++k) states[k].t = k * time_step;
  AccelerationSolver<F<double>> one(mechanism);
  AccelerationSolver<F<Four>> four(in_lanes);
  const auto all = pack<double, Four::lanes>(std::span<const MechanismState<double>, Four::lanes>(states));
  four.solve(to_coordinates<F<Four>>(in_lanes, all, {}), all.t);
  for (int k = 0; k < Four::lanes; ++k) {
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
  expect_lanes_are_the_states<ROmega>(scenes::chain(7));
  expect_lanes_are_the_states<RP>(scenes::chain(7));
  expect_lanes_are_the_states<REpsilon>(scenes::chain(7));
  expect_lanes_are_the_states<ROmega>(scenes::ladder(3));
  expect_lanes_are_the_states<ROmega>(test::random_scene(8, {.bodies = 4, .closings = 1}));
}

TEST(Batch, EachLaneHasItsTime) {
  expect_lanes_are_the_states<ROmega>(test::random_scene(8, {.bodies = 3, .closings = 1, .driven = true}),
                                      0.1);
}

TEST(Batch, RefusesABranchOnWhichItsLanesDisagree) {
  Four x(1.0);
  x.set(2, -1);
  EXPECT_THROW(static_cast<void>(x > Four(0) ? 1 : 2), MixedLanes);
  EXPECT_TRUE(abs(x) == Four(1));
  EXPECT_EQ(select(x > Four(0), Four(3), Four(4))[2], 4);
}

TEST(Batch, ARowThatStandsInEachLaneByAnotherColumnDoesNotPassForDependent) {
  // along x in two lanes, along y in the others, so that no column is a pivot in all, and z is zero in all
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
  std::array<bool, 6> dropped;
  GeneralLink<Four> link;
  const BodyColumns<Four> parent;
  EXPECT_THROW(link.factor(H, {none, C, parent, 1}, nullptr, dropped), MixedLanes);
}

TEST(Batch, TheWorstLaneIsTheOneThatIsNotANumber) {
  Four x(1.0);
  x.set(1, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(std::isnan(largest_lane(x)));
}

}  // namespace
}  // namespace trivium
