/// The equations of motion with constraints, as implicit methods use them.

#include "simulation/system/constrained_equations.hpp"

#include "base/raise.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/printed_and_structured.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::distance, test::Random;
using StateVector = VectorX<double>;

template <class F>
class Constrained : public testing::Test {};
TYPED_TEST_SUITE(Constrained, test::AllFormulations<double>, test::FormulationNames);

template <class F>
ConstrainedEquations<F> form_of(const scenes::Scene& scene) {
  return {make_mechanism<double>(scene), make_state<double>(scene)};
}

/// The equations of a step at a state, with v', lambda and the residuals.
template <class F>
struct Step {
  ConstrainedEquations<F>& form;
  StateVector v_dot, lambda, force, left, phi, phi_dot;
  typename ConstrainedEquations<F>::Evaluation at;
  typename ConstrainedEquations<F>::Factors factors;

  explicit Step(ConstrainedEquations<F>& f) : form(f) { form.accelerations(0, form.start(), v_dot, lambda); }
  double imbalance(const StateVector& y) {
    form.evaluate(0, y, at);
    form.inertia_force(at, v_dot, force);
    return form.residual(at, force, lambda, left);
  }
  double violation() { return form.position_rows(at, phi).relative; }
  /// One Newton correction of v' and lambda; `position_share` is beta' = dq/dv'.
  void correct(const integrators::Shares<double>& shares, double position_share) {
    violation();
    form.factor(at, shares, factors);
    form.solve(factors, at, left, phi / -position_share, v_dot, lambda);
  }
};

TYPED_TEST(Constrained, ForcesBalanceWhereTheMotionIs) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    auto form = form_of<TypeParam>(test::varied_scene(seed));
    Step<TypeParam> step(form);
    EXPECT_LE(step.imbalance(form.start()), 1e-12) << seed;
    EXPECT_LE(step.violation(), 1e-13) << seed;
    // random scenes may start with velocities that violate the rows of drivers, so only equality is tested
    EXPECT_NEAR(form.velocity_rows(step.at, step.phi_dot).relative,
                form.velocity_violation(0, form.start()).relative, 1e-12)
        << seed;
    // a changed acceleration is not in balance
    step.v_dot[0] += 1e-3 * (1 + step.v_dot.cwiseAbs().maxCoeff());
    EXPECT_GT(step.imbalance(form.start()), 1e-7) << seed;
  }
}

// the equations are linear in v' and lambda; shares near 0 leave q and v fixed, so one iteration is exact
TYPED_TEST(Constrained, NewtonFindsAccelerationsAndLambdaInOneIteration) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    auto form = form_of<TypeParam>(test::varied_scene(seed));
    Step<TypeParam> step(form);
    const StateVector v_dot = step.v_dot, lambda = step.lambda;
    Random random(seed);
    // only lambda is perturbed, in independent rows: Phi stays 0, so the rows demand no correction of v'
    for (double& x : step.lambda) x += x == 0 ? 0 : random.uniform();
    step.imbalance(form.start());
    step.correct({1e-12, 1e-12}, 1e30);
    EXPECT_LE(step.imbalance(form.start()), 1e-11) << seed;
    EXPECT_LE(distance(step.v_dot, v_dot), 1e-9 * (1 + v_dot.norm())) << seed;
  }
}

TYPED_TEST(Constrained, NewtonMeetsPositionsByTheirShare) {
  constexpr double h = 1e-4;
  for (const char* name : {"spatial_slider_crank", "heavy_top", "stewart_platform", "triple_pendulum"}) {
    auto form = form_of<TypeParam>(catalogue_scene(name));
    Step<TypeParam> step(form);
    const StateVector from = form.start(), v = from.segment(form.position_size(), form.velocity_size());
    StateVector y = from;
    const auto place = [&] {
      form.displace(from, StateVector(h * v + h * h / 2 * step.v_dot), y);
      if (form.normalise_step(h * h / 2, y, step.v_dot))
        form.displace(from, StateVector(h * v + h * h / 2 * step.v_dot), y);
    };
    step.v_dot.setZero();
    place();
    step.imbalance(y);
    const double before = step.violation();
    EXPECT_GT(before, 1e-10) << name;
    step.correct({h * h / 2, h}, h * h / 2);
    place();
    step.imbalance(y);
    // the remaining violation is quadratic in the first one, plus the part from the rotation in the step
    double turned = 0;
    for (const Twist<double>& twist : form.first_order().to_mechanism_state(0, from).twist)
      raise(turned, h * twist.omega_bar.norm());
    EXPECT_LE(step.violation(), (5e-3 + turned) * before) << name;
  }
}

// a step dominated by a stiff spring: without K in the matrix, errors would grow by h^2 k / m per iteration
TYPED_TEST(Constrained, SpringsAreInNewtonsMatrix) {
  auto form = form_of<TypeParam>(catalogue_scene("flyball_governor"));
  Step<TypeParam> step(form);
  const double h = 0.01, share = h * h / 2;
  const StateVector from = form.start(), v = from.segment(form.position_size(), form.velocity_size());
  StateVector y = from;
  double before = 0;
  for (int k = 0; k < 12; ++k) {
    form.displace(from, StateVector(h * v + share * step.v_dot), y);
    if (form.normalise_step(share, y, step.v_dot))
      form.displace(from, StateVector(h * v + share * step.v_dot), y);
    y.segment(form.position_size(), form.velocity_size()) = v + h * step.v_dot;
    before = step.imbalance(y);
    step.correct({share, h}, share);
  }
  EXPECT_LE(before, 1e-6);
  EXPECT_LE(step.violation(), 1e-6);
}

TYPED_TEST(Constrained, DisplacementsLeadFromStateToState) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    auto form = form_of<TypeParam>(test::varied_scene(seed));
    const StateVector from = form.start();
    Random random(seed);
    const StateVector by = StateVector::NullaryExpr(form.velocity_size(),
                                                    [&](Eigen::Index) { return random.uniform(-0.1, 0.1); });
    StateVector to = from, found;
    form.displace(from, by, to);
    form.displacement(from, to, found);
    EXPECT_LE(distance(found, by), 1e-13) << seed;
  }
}

TYPED_TEST(Constrained, PositionsGrowAsTheFirstOrderFormSays) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    auto form = form_of<TypeParam>(test::varied_scene(seed));
    const StateVector y = form.start();
    StateVector y_dot, rate;
    form.derivative(0, y, y_dot);
    form.position_rate(y, y.segment(form.position_size(), form.velocity_size()), rate);
    EXPECT_LE(distance(rate, y_dot.head(form.position_size())), 1e-14 * (1 + rate.norm())) << seed;
  }
}

TYPED_TEST(Constrained, APlaceIsAsLargeAsItIsFarFromTheOriginOrItsBodyReachesAndATurnIsOne) {
  auto form = form_of<TypeParam>(test::varied_scene(0));
  const auto reach = reaches(form.first_order().mechanism());
  const StateVector y = form.start();
  StateVector sizes;
  form.position_sizes(y, sizes);
  const int positions = form.position_size() / form.nb(), velocities = form.velocity_size() / form.nb();
  for (int b = 0; b < form.nb(); ++b)
    for (int k = 0; k < velocities; ++k)
      EXPECT_EQ(sizes[velocities * b + k],
                k < 3 ? std::max(y.segment<3>(positions * b).norm(), reach[b]) : 1.0)
          << b << " " << k;
}

TYPED_TEST(Constrained, AccelerationsLeaveNothingOfInternalRowsAndWhatIsLeftIsSolvedFor) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    auto form = form_of<TypeParam>(test::varied_scene(seed));
    Step<TypeParam> step(form);
    step.imbalance(form.start());
    StateVector left = StateVector::Zero(form.velocity_size());
    form.internal_residual(step.at, step.v_dot, left);
    const double size = 1 + step.v_dot.norm() + form.start().squaredNorm();
    EXPECT_LE(left.norm(), 1e-13 * size) << seed;
    Random random(seed);
    for (double& x : step.v_dot) x += random.uniform();
    form.internal_residual(step.at, step.v_dot, left);
    EXPECT_EQ(left.norm() > 1e-3, TypeParam::internal_constraints > 0) << seed;
    form.solve_internal_rows(step.at, left, step.v_dot);
    left.setZero();
    form.internal_residual(step.at, step.v_dot, left);
    EXPECT_LE(left.norm(), 1e-13 * size) << seed;
  }
}

TYPED_TEST(Constrained, WorkRateIsThatOfTheFirstOrderForm) {
  for (const char* name : {"flyball_governor", "driven_crank", "basic_drivers", "open_arm_7"}) {
    auto form = form_of<TypeParam>(catalogue_scene(name));
    Step<TypeParam> step(form);
    StateVector y_dot;
    form.derivative(0, form.start(), y_dot);
    step.imbalance(form.start());
    EXPECT_NEAR(form.work_rate(step.at, step.lambda), y_dot[form.first_order().motion_size()],
                1e-9 * (1 + std::abs(y_dot[form.first_order().motion_size()])))
        << name;
  }
}

// evaluations and factors are values: work at one state does not change the results at another
TYPED_TEST(Constrained, EvaluationsAndFactorsOfTwoStatesStandSideBySide) {
  for (const char* name : {"flyball_governor", "spatial_slider_crank"}) {
    auto form = form_of<TypeParam>(catalogue_scene(name));
    Step<TypeParam> alone(form), beside(form), other(form);
    StateVector away = form.start();
    form.displace(form.start(), StateVector::Constant(form.velocity_size(), 0.01), away);
    const integrators::Shares<double> shares{1e-6, 1e-3};
    alone.imbalance(form.start());
    alone.correct(shares, 1);

    beside.imbalance(form.start());
    other.imbalance(away);
    beside.violation();
    form.factor(beside.at, shares, beside.factors);
    other.correct({}, 1);
    other.imbalance(form.start());  // must not reuse storage that factors still use
    form.solve(beside.factors, beside.at, beside.left, -beside.phi, beside.v_dot, beside.lambda);
    EXPECT_EQ(beside.v_dot, alone.v_dot) << name;
    EXPECT_EQ(beside.lambda, alone.lambda) << name;
  }
}

TYPED_TEST(Constrained, AnEvaluationIsMadeBeforeItIsAskedAndFactoredOnce) {
  auto form = form_of<TypeParam>(catalogue_scene("door"));
  Step<TypeParam> step(form);
  EXPECT_THROW(form.position_rows(step.at, step.phi), std::logic_error);
  EXPECT_THROW(form.reduce(step.factors, step.v_dot, step.left), std::logic_error);
  step.imbalance(form.start());
  form.factor(step.at, {}, step.factors);
  EXPECT_THROW(form.factor(step.at, {}, step.factors), std::logic_error);
}

// the storage of another mechanism does not fit and is replaced
TYPED_TEST(Constrained, AnEvaluationServesAnotherMechanism) {
  auto door = form_of<TypeParam>(catalogue_scene("door")),
       top = form_of<TypeParam>(catalogue_scene("heavy_top"));
  Step<TypeParam> of_door(door), of_top(top), again(top);
  of_door.imbalance(door.start());
  of_door.correct({}, 1);
  again.at = std::move(of_door.at);
  again.factors = std::move(of_door.factors);
  for (Step<TypeParam>* step : {&of_top, &again}) {
    step->imbalance(top.start());
    step->correct({}, 1);
  }
  EXPECT_EQ(again.v_dot, of_top.v_dot);
  EXPECT_EQ(again.lambda, of_top.lambda);
}

TYPED_TEST(Constrained, RedundantRowsAreLeftOutAsTheMotionHasThem) {
  for (const char* name : {"bricard", "parallelogram", "four_bar", "door"}) {
    auto form = form_of<TypeParam>(catalogue_scene(name));
    Step<TypeParam> step(form);
    const StateVector v_dot = step.v_dot;
    step.v_dot.setZero();
    step.lambda.setZero();
    step.imbalance(form.start());
    step.correct({1e-12, 1e-12}, 1e30);  // a share of 1e30 makes the right side of the rows 0: Phi_q v' = 0
    EXPECT_TRUE(step.v_dot.allFinite()) << name;
    EXPECT_LE(step.lambda.cwiseAbs().maxCoeff(), 1e6) << name;
  }
}

}  // namespace
}  // namespace trivium
