/// The structured solver in float agrees with the printed system, also at large mass ratios.

#include "formulations/testing/printed_and_structured.hpp"

namespace trivium {
namespace {

TEST(StructuredSolver, AgreesWithThePrintedSystemInFloat) {
  test::expect_agreement_on<ROmega<float>>(40);
  test::expect_agreement_on<RP<float>>(40);
  test::expect_agreement_on<REpsilon<float>>(40);
}

TEST(StructuredSolver, RefinesUntilMassRatiosOfAMillionAreRightInFloat) {
  for (std::uint64_t seed = 50; seed < 80; ++seed) {
    test::MechanismOptions o;
    o.bodies = 2 + static_cast<int>(seed % 5);
    o.closings = static_cast<int>(seed % 2);
    o.mass_decades = 3;
    const scenes::Scene scene = test::random_scene(seed, o);
    const std::string what = "seed " + std::to_string(seed);
    test::expect_agreement<ROmega<float>>(scene, what);
    test::expect_agreement<REpsilon<float>>(scene, what);
  }
}

}  // namespace
}  // namespace trivium
