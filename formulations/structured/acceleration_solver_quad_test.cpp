/// The structured solver in quad agrees with the printed system.

#include "formulations/testing/printed_and_structured.hpp"

#include "bodies/numbers/quad.hpp"

namespace trivium {
namespace {

TEST(StructuredSolver, AgreesWithThePrintedSystemInQuad) {
  test::expect_agreement_on<ROmega<Quad>>(20);
  test::expect_agreement_on<RP<Quad>>(20);
  test::expect_agreement_on<REpsilon<Quad>>(20);
}

}  // namespace
}  // namespace trivium
