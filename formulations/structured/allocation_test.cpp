/// A second solution allocates no memory. A separate executable, since all allocations are counted.

#include <gtest/gtest.h>

#include "base/testing/counted_allocations.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/r_epsilon.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium {
namespace {

template <template <class> class Formulation>
long long allocations_of_a_second_solve(const scenes::Scene& scene) {
  using F = Formulation<double>;
  const auto mechanism = make_mechanism<double>(scene);
  const auto state = make_state<double>(scene);
  const auto bodies = to_coordinates<F>(mechanism, state, {});
  AccelerationSolver<F> solver(mechanism);
  solver.solve(bodies, state.t);
  const long long before = test::allocations();
  solver.solve(bodies, state.t);
  return test::allocations() - before;
}

void expect_none(const scenes::Scene& scene) {
  EXPECT_EQ(allocations_of_a_second_solve<ROmega>(scene), 0);
  EXPECT_EQ(allocations_of_a_second_solve<RP>(scene), 0);
  EXPECT_EQ(allocations_of_a_second_solve<REpsilon>(scene), 0);
}

TEST(Allocations, AreCounted) {
  static MatrixX<double> kept;
  const long long before = test::allocations();
  kept = MatrixX<double>::Random(3, 3);
  static std::vector<int> numbers;
  numbers.assign(kept.size(), 1);
  EXPECT_EQ(test::allocations() - before, 2);
}

TEST(Allocations, ATreeSolvedAgainMakesNone) { expect_none(scenes::chain(10)); }
TEST(Allocations, LoopsSolvedAgainMakeNone) {
  expect_none(scenes::ladder(3));
  expect_none(scenes::ring(6));
}
TEST(Allocations, RowsThatAreLookedAtOneByOneMakeNone) {
  expect_none(test::random_scene(3, {.bodies = 3, .closings = 1, .near_rows = 1e-6}));
  scenes::Scene drifted = scenes::ladder(3);
  test::Random random(1);
  for (scenes::Constraint& c : drifted.constraints) (*c.j.axis)[0] += 1e-10 * random.uniform();
  expect_none(drifted);
}
TEST(Allocations, DriversAndEffectsMakeNone) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    test::MechanismOptions o;
    o.bodies = 3;
    o.closings = static_cast<int>(seed % 3);
    o.driven = seed % 2 == 0;
    expect_none(test::random_scene(seed, o));
  }
}

}  // namespace
}  // namespace trivium
