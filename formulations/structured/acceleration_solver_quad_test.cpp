/// The structured solver in quad agrees with the printed system.

#include "formulations/testing/printed_and_structured.hpp"

#include "bodies/numbers/quad.hpp"
#include "formulations/structured/testing/dependent_rows_scenes.hpp"

namespace trivium {
namespace {

TEST(StructuredSolver, AgreesWithThePrintedSystemInQuad) {
  test::expect_agreement_on<ROmega<Quad>>(20);
  test::expect_agreement_on<RP<Quad>>(20);
  test::expect_agreement_on<REpsilon<Quad>>(20);
}

TEST(StructuredSolver, FollowsALargeRankToleranceInQuad) {
  scenes::Scene scene = test::block_on_rows({0.3, 0.3 + 1e-6, -1}, 1);
  test::expect_solution_of_quad<ROmega<Quad>>(scene, 1e-12, "the standard rank tolerance");
  scene.rank_tolerance = 1e-4;
  const auto mechanism = make_mechanism<Quad>(scene);
  AccelerationSolver<ROmega<Quad>> solver(mechanism);
  solver.solve(to_coordinates<ROmega<Quad>>(mechanism, make_state<Quad>(scene), {}), Quad(0));
  EXPECT_EQ(solver.rank(), 2);
}

}  // namespace
}  // namespace trivium
