/// The equations of motion satisfy the laws of the contract for systems (integrators/contract/laws.hpp), and
/// these laws detect equations with a single error.

#include "formulations/testing/printed_and_structured.hpp"
#include "integrators/contract/laws.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "simulation/system/constrained_equations.hpp"

namespace trivium {
namespace {

using test::catalogue_scene;
using StateVector = VectorX<double>;

template <class System>
std::vector<BrokenLaw> broken_laws_on(const char* scene) {
  const scenes::Scene read = catalogue_scene(scene);
  System system{make_mechanism<double>(read), make_state<double>(read)};
  return integrators::broken_laws(system, 0.0, system.start());
}

template <class F>
class EquationsWithConstraints : public testing::Test {};
TYPED_TEST_SUITE(EquationsWithConstraints, test::AllFormulations<double>, test::FormulationNames);

TYPED_TEST(EquationsWithConstraints, KeepTheLawsOfAConstrainedSystem) {
  for (const char* name :
       {"heavy_top", "spatial_slider_crank", "flyball_governor", "stewart_platform", "four_bar", "bricard",
        "driven_crank", "basic_drivers", "open_arm_7", "a01_pendulum"}) {
    for (const BrokenLaw& broken : broken_laws_on<ConstrainedEquations<TypeParam>>(name))
      ADD_FAILURE() << name << ": " << broken.text();
  }
}

// equations with one error each
template <class F>
struct StifferSprings : ConstrainedEquations<F> {
  using ConstrainedEquations<F>::ConstrainedEquations;
  void spring_constants(StateVector& stiffness, StateVector& damping) const {
    ConstrainedEquations<F>::spring_constants(stiffness, damping);
    stiffness *= 2;
  }
};
template <class F>
struct SpringsWithoutSlack : ConstrainedEquations<F> {
  using Base = ConstrainedEquations<F>;
  using Base::Base, Base::solve;
  void solve(const typename Base::Factors& factors, const typename Base::Evaluation& at,
             const StateVector& left, const StateVector& rows, const StateVector& slack, StateVector& x,
             StateVector& mu, StateVector& stretch) {
    Base::solve(factors, at, left, rows, StateVector::Zero(slack.size()), x, mu, stretch);
  }
};
template <class F>
struct WorksTwice : ConstrainedEquations<F> {
  using Base = ConstrainedEquations<F>;
  using Base::Base;
  double work_rate(const typename Base::Evaluation& at, const StateVector& lambda) {
    return 2 * Base::work_rate(at, lambda);
  }
};
template <class F>
struct LeavesInternalRows : ConstrainedEquations<F> {
  using Base = ConstrainedEquations<F>;
  using Base::Base;
  void solve_internal_rows(const typename Base::Evaluation&, const StateVector&, StateVector&) const {}
};

TEST(LawsOfAConstrainedSystem, FindWhatIsWrongInOnePlace) {
  EXPECT_FALSE(broken_laws_on<StifferSprings<RP<double>>>("flyball_governor").empty());
  EXPECT_FALSE(broken_laws_on<SpringsWithoutSlack<RP<double>>>("flyball_governor").empty());
  EXPECT_FALSE(broken_laws_on<WorksTwice<ROmega<double>>>("driven_crank").empty());
  EXPECT_FALSE(broken_laws_on<LeavesInternalRows<RP<double>>>("heavy_top").empty());
}

}  // namespace
}  // namespace trivium
