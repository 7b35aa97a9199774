#include "formulations/solved_twice.hpp"

namespace trivium {
namespace {

TEST(StructuredSolver, AgreesWithThePrintedSystemInFloat) {
  test::expect_agreement_on<ROmega<float>>(40);
  test::expect_agreement_on<RP<float>>(40);
  test::expect_agreement_on<REpsilon<float>>(40);
}

}  // namespace
}  // namespace trivium
