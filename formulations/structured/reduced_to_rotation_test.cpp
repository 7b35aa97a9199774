/// ReducedToRotation completes a formulation that has its printed equations only. Its structured solution
/// must be that of the printed system.

#include "formulations/contract/reduced_to_rotation.hpp"

#include <gtest/gtest.h>

#include "formulations/equations_of_motion_impl.hpp"
#include "formulations/structured/acceleration_solver_impl.hpp"
#include "formulations/testing/printed_and_structured.hpp"

namespace trivium {
namespace {

/// r-p with its printed equations only.
template <class S>
struct PrintedEulerParameters : RP<S> {
  using Reduced = void;
  using Orientation = void;
};

template <class F>
class ReducedToRotationOf : public testing::Test {};
using Formulations = testing::Types<RP<double>, REpsilon<double>>;
TYPED_TEST_SUITE(ReducedToRotationOf, Formulations);

TYPED_TEST(ReducedToRotationOf, HasThePrintedSolution) {
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    test::expect_agreement<ReducedToRotation<TypeParam>>(test::varied_scene(seed), std::to_string(seed));
}

TEST(WholeFormulation, IsTheFormulationItselfWhereItHasAllParts) {
  static_assert(std::is_same_v<WholeFormulation<RP<double>>, RP<double>>);
  static_assert(EquationsAsPrinted<PrintedEulerParameters<double>>);
  static_assert(!Formulation<PrintedEulerParameters<double>>);
  static_assert(Formulation<WholeFormulation<PrintedEulerParameters<double>>>);
  static_assert(std::is_same_v<InScalarT<WholeFormulation<PrintedEulerParameters<double>>, float>,
                               ReducedToRotation<PrintedEulerParameters<float>>>);
}

}  // namespace
}  // namespace trivium
