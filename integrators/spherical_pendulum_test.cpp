/// Every method on its own, on a one-page model: a spherical pendulum in Cartesian coordinates.

#include "integrators/contract/spherical_pendulum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <vector>

#include "integrators/contract/laws.hpp"
#include "integrators/implicit/bdf.hpp"
#include "integrators/implicit/generalized_alpha.hpp"
#include "integrators/implicit/hht.hpp"
#include "integrators/integrate.hpp"
#include "integrators/method_laws.hpp"
#include "integrators/methods.hpp"
#include "integrators/quad.hpp"
#include "integrators/symplectic/rattle.hpp"

namespace trivium::integrators {

/// GoogleTest prints a parameter by its name.
[[maybe_unused]] static void PrintTo(const MethodInfo& method, std::ostream* to) { *to << method.name; }

namespace {

std::vector<MethodInfo> methods_that(bool MethodInfo::*takes) {
  std::vector<MethodInfo> chosen;
  for (const MethodInfo& method : methods())
    if (method.*takes) chosen.push_back(method);
  return chosen;
}
const auto in_a_name = [](const auto& method) {
  std::string name(method.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
};

/// The end of a run: the state and the method's own multiplier.
template <class S>
struct End {
  StateVector<S> y;
  S lambda{0};
};

constexpr double t_end = 0.5;

template <class S>
End<S> run(AnyMethod<S>& method, bool projects, std::optional<double> h, double start = 0) {
  SphericalPendulum<S> pendulum;
  SystemAdapter<SphericalPendulum<S>> system(pendulum);
  ProjectionReport<S> report;
  End<S> end;
  integrate<S>(
      system, method, TimeGrid(start, start + t_end, {}, h), projects, report,
      [](const S&, const StateVector<S>&) { return Continue::yes; },
      [&](const S&, const StateVector<S>& y) {
        end.y = y;
        return Continue::yes;
      });
  if (const StateVector<S>* lambda = method.lambda()) end.lambda = (*lambda)[0];
  return end;
}

/// Reference solution in quad, far more accurate than the runs of the tests.
const End<Quad>& exact() {
  static const End<Quad> end = [] {
    const auto method = make_method<Quad>("rkf78", Steps::given, {});
    End<Quad> found = run<Quad>(*method, true, t_end / 512);
    StateVector<Quad> v_dot, lambda;
    SphericalPendulum<Quad>().accelerations(0, found.y, v_dot, lambda);
    found.lambda = lambda[0];
    return found;
  }();
  return end;
}

/// Errors of positions and velocities, and of the method's own multiplier.
struct Errors {
  double y, lambda;
};
template <class S>
Errors errors_of(const End<S>& end) {
  const StateVector<Quad> y = end.y.template cast<Quad>();
  return {static_cast<double>(Quad((y - exact().y).norm())),
          std::abs(static_cast<double>(Quad(Quad(end.lambda) - exact().lambda)))};
}

template <class S>
Errors at_steps(const MethodInfo& method, double h, const MethodParameters& given = {}) {
  const auto made = make_method<S>(method.name, Steps::given, {}, given);
  return errors_of(run<S>(*made, !method.meets_constraints, h));
}

/// Measures the order between h and h / 2, where errors are above rounding.
template <class S>
void expect_order(const MethodInfo& method, double h, const MethodParameters& given = {}) {
  const int order = given.order.value_or(method.order);
  const Errors coarse = at_steps<S>(method, h, given), fine = at_steps<S>(method, h / 2, given);
  EXPECT_NEAR(std::log2(coarse.y / fine.y), order, 0.2) << coarse.y << " " << fine.y;
  if (!method.has_raw_lambda) return;
  EXPECT_NEAR(std::log2(coarse.lambda / fine.lambda), given.order.value_or(method.raw_lambda_order), 0.2)
      << coarse.lambda << " " << fine.lambda;
}

TEST(SphericalPendulum, IsAConicalPendulumWhereItTurnsAtTheRightSpeed) {
  SphericalPendulum<double> pendulum;
  // radius 0.6 at a depth of 0.8: v^2 = g r tan(angle)
  pendulum.v0 = {0, std::sqrt(10 * 0.6 * 0.6 / 0.8), 0};
  StateVector<double> y_dot;
  pendulum.derivative(0, pendulum.start(), y_dot);
  EXPECT_NEAR(y_dot[5], 0, 1e-14);
  EXPECT_NEAR(y_dot[3], -pendulum.v0.squaredNorm() / 0.6, 1e-13);
}

TEST(SphericalPendulum, KeepsTheLawsOfAConstrainedSystem) {
  SphericalPendulum<double> pendulum;
  for (const BrokenLaw& broken : broken_laws(pendulum, 0.0, pendulum.start())) ADD_FAILURE() << broken.text();
}

class GivenStepsOnThePendulum : public testing::TestWithParam<MethodInfo> {};

TEST_P(GivenStepsOnThePendulum, DoNotDependOnTheTime) {
  const auto from = [](double start) {
    const auto method = make_method<double>(GetParam().name, Steps::given, {});
    return run<double>(*method, !GetParam().meets_constraints, 1e-3, start).y;
  };
  // 1e-3 s is no binary number: all times are rounded, late ones by 1e-10 s, and so are differences of them
  EXPECT_LE((from(1e6) - from(0)).norm(), 1e-11);
}

TEST_P(GivenStepsOnThePendulum, HaveTheOrderThatTheListSays) {
  const MethodInfo& method = GetParam();
  if (method.order == 0) {
    ASSERT_TRUE(method.takes_order);
    for (int order = 1; order <= 5; ++order) expect_order<Quad>(method, t_end / 512, {.order = order});
  } else if (method.name.starts_with("arkode")) {
    expect_order<double>(method, t_end / 32);
  } else {
    expect_order<Quad>(method, t_end / (method.order < 8 ? 512 : 32));
  }
}
INSTANTIATE_TEST_SUITE_P(Methods, GivenStepsOnThePendulum,
                         testing::ValuesIn(methods_that(&MethodInfo::takes_given_steps)), in_a_name);

class EveryMethod : public testing::TestWithParam<MethodInfo> {};

TEST_P(EveryMethod, KeepsTheLawsThatItsEntrySays) {
  for (const BrokenLaw& broken : broken_laws(method_entry<double>(GetParam().name)))
    ADD_FAILURE() << broken.text();
}
INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, testing::ValuesIn(methods()), in_a_name);

// the laws must be able to fail: here each entry contradicts its method in one property
TEST(MethodLaws, FindAnEntryThatDoesNotDescribeItsMethod) {
  const auto broken_when = [](const auto& change, const char* name) {
    MethodEntry<double> entry = method_entry<double>(name);
    change(entry.info);
    return !broken_laws(entry).empty();
  };
  EXPECT_FALSE(broken_when([](MethodInfo&) {}, "hht"));
  EXPECT_TRUE(broken_when([](MethodInfo& info) { info.order = 3; }, "hht"));
  EXPECT_TRUE(broken_when([](MethodInfo& info) { info.has_raw_lambda = false; }, "hht"));
  EXPECT_TRUE(broken_when([](MethodInfo& info) { info.raw_lambda_order = 3; }, "hht"));
  EXPECT_TRUE(broken_when([](MethodInfo& info) { info.takes_given_steps = false; }, "rattle4"));
  EXPECT_TRUE(broken_when([](MethodInfo& info) { info.meets_constraints = true; }, "abm"));
}

// a method template takes the model itself, without AnySystem
template <class M>
double error_of_template(M method, double h) {
  SphericalPendulum<double> pendulum;
  StateVector<double> y = pendulum.start();
  const int steps = static_cast<int>(std::lround(t_end / h));
  double t = 0;
  for (int k = 1; k <= steps; ++k) method.step(pendulum, t, y, k * h);
  return errors_of(End<double>{y}).y;
}

TEST(MethodsAsTemplates, TakeTheModelItself) {
  using Pendulum = SphericalPendulum<double>;
  const double h = t_end / 512;
  EXPECT_LT(error_of_template(GeneralizedAlpha<Pendulum>(0.8, false, {}), h), 1e-5);
  EXPECT_LT(error_of_template(GeneralizedAlpha<Pendulum>(0.8, true, {}), h), 1e-5);
  EXPECT_LT(error_of_template(HHT<Pendulum>(-0.1, {}), h), 1e-5);
  EXPECT_LT(error_of_template(BDF<Pendulum>(3, {}), h), 1e-6);
  EXPECT_LT(error_of_template(Radau5<Pendulum>({}, {}), h), 1e-12);
  EXPECT_LT(error_of_template(Rattle<Pendulum>(2), h), 1e-5);
}

/// Its displacement_rate is always 0, so that no correction balances the momentum.
struct PendulumWithAWrongRate : SphericalPendulum<double> {
  void displacement_rate(const StateVector<double>&, const StateVector<double>& velocity,
                         StateVector<double>& rate) const {
    rate = 0 * velocity;  // no displacement balances the momentum
  }
};

template <class Pendulum>
std::string failure_of_rattle(double h) {
  Pendulum pendulum;
  Rattle<Pendulum> method(2);
  StateVector<double> y = pendulum.start();
  double t = 0;
  try {
    method.step(pendulum, t, y, h);
  } catch (const IntegrationError& error) {
    return error.what();
  }
  return {};
}

TEST(MethodsAsTemplates, RattleReportsARowOrTheBalanceThatItCannotSatisfy) {
  const auto contains = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  // the step is longer than the diameter of the sphere: no point of the sphere is near its end
  const std::string of_row = failure_of_rattle<SphericalPendulum<double>>(1);
  EXPECT_TRUE(contains(of_row, "row \"sphere\"") && contains(of_row, "constraint row")) << of_row;
  const std::string of_balance = failure_of_rattle<PendulumWithAWrongRate>(1e-4);
  EXPECT_TRUE(contains(of_balance, "balance the momentum") && !contains(of_balance, "row")) << of_balance;
}

// also by name, a method requires only the groups of functions that it uses
struct PendulumWithoutSprings : SphericalPendulum<double> {
  int springs() const = delete;
};
static_assert(HasNewtonMatrix<PendulumWithoutSprings> && HasInternalRows<PendulumWithoutSprings>);
static_assert(!HasSprings<PendulumWithoutSprings>);

TEST(MethodsByName, AskForTheGroupsThatTheyNeed) {
  PendulumWithoutSprings pendulum;
  SystemAdapter<PendulumWithoutSprings> system(pendulum);
  const auto step_with = [&](const char* name) {
    StateVector<double> y = pendulum.start();
    double t = 0;
    make_method<double>(name, Steps::given, {})->step(system, t, y, 1e-3);
  };
  for (const char* name : {"generalized-alpha", "generalized-alpha-gl2", "hht", "rattle", "hem4"})
    EXPECT_NO_THROW(step_with(name)) << name;
  try {
    step_with("radau5");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("HasSprings"), std::string::npos) << error.what();
  }
}

TEST(MethodsByName, InterpolateWhereTheMethodDoes) {
  struct Method {
    Counters counted;
    void step(AnySystem<double>&, double& t, StateVector<double>&, double stop) { t = stop; }
    void restart() {}
    bool shorten() { return false; }
    const Counters& counters() const { return counted; }
    bool interpolates() const { return true; }
    void interpolate(double t, StateVector<double>& y) { y.setConstant(1, t); }
  };
  const auto method = adapt<double>(Method());
  StateVector<double> y;
  method->interpolate(0.25, y);
  EXPECT_TRUE(method->interpolates());
  EXPECT_EQ(y[0], 0.25);
}

/// Its equations fail more than 0.02 s after the last accepted state.
struct ShortSighted : SphericalPendulum<double> {
  double accepted = 0;

  bool accept_state(const double& t, Y&) {
    accepted = t;
    return false;
  }
  void derivative(const double& t, const Y& y, Y& y_dot) const {
    require_near(t);
    SphericalPendulum::derivative(t, y, y_dot);
  }
  void evaluate(const double& t, const Y& y, Evaluation& at) const {
    require_near(t);
    SphericalPendulum::evaluate(t, y, at);
  }
  void require_near(double t) const {
    if (t > accepted + 0.02) throw IntegrationError("the equations are not known there");
  }
};

class MethodsThatChooseSteps : public testing::TestWithParam<MethodInfo> {};
TEST_P(MethodsThatChooseSteps, TakeShorterOnesWhereTheEquationsFail) {
  const auto method =
      make_method<double>(std::string(GetParam().name), Steps::chosen, {.rtol = 1e-2, .atol = 1e-2});
  ShortSighted pendulum;
  SystemAdapter<ShortSighted> system(pendulum);
  ProjectionReport<double> report;
  const auto go_on = [](const double&, const StateVector<double>&) { return Continue::yes; };
  const auto run = [&] {
    return integrate<double>(system, *method, TimeGrid(0, t_end, {}, {}), !GetParam().meets_constraints,
                             report, go_on, go_on);
  };
  if (GetParam().name == "arkode-erk") {  // ARKODE ends a run in which an explicit stage fails
    EXPECT_THROW(run(), IntegrationError);
    return;
  }
  EXPECT_TRUE(run());
  EXPECT_GE(method->counters().steps, 25);
}

/// One of its evaluations finds no memory.
struct WithoutMemory : SphericalPendulum<double> {
  using SphericalPendulum::solve;
  int failing = 0;
  mutable int evaluations = 0;

  void derivative(const double& t, const Y& y, Y& y_dot) const {
    count();
    SphericalPendulum::derivative(t, y, y_dot);
  }
  void evaluate(const double& t, const Y& y, Evaluation& at) const {
    count();
    SphericalPendulum::evaluate(t, y, at);
  }
  void solve(const Factors& factors, const Evaluation& at, const Y& left, const Y& rows, Y& x, Y& mu) const {
    count();
    SphericalPendulum::solve(factors, at, left, rows, x, mu);
  }
  void count() const {
    if (++evaluations == failing) throw std::bad_alloc();
  }
};

TEST_P(MethodsThatChooseSteps, EndTheRunWhereMemoryIsFull) {
  for (int failing = 1; failing <= 80; ++failing) {
    const auto method =
        make_method<double>(std::string(GetParam().name), Steps::chosen, {.rtol = 1e-8, .atol = 1e-8});
    WithoutMemory pendulum;
    pendulum.failing = failing;
    SystemAdapter<WithoutMemory> system(pendulum);
    ProjectionReport<double> report;
    const auto go_on = [](const double&, const StateVector<double>&) { return Continue::yes; };
    EXPECT_THROW(integrate<double>(system, *method, TimeGrid(0, t_end, {}, {}), !GetParam().meets_constraints,
                                   report, go_on, go_on),
                 std::bad_alloc)
        << "at evaluation " << failing;
  }
}
INSTANTIATE_TEST_SUITE_P(Methods, MethodsThatChooseSteps,
                         testing::ValuesIn(methods_that(&MethodInfo::chooses_steps)), in_a_name);

// each of these models breaks a law of the contract
struct AddsTwice : SphericalPendulum<double> {
  void displace(const Y& from, const Y& by, Y& to) const { to.head(3) = from.head(3) + 2 * by; }
};
struct CorrectsBackwards : SphericalPendulum<double> {
  void correct_positions(double, Y& y, bool) const { y.head(3) *= 1.001; }
};
struct ForgetsGravity : SphericalPendulum<double> {
  double residual(const Evaluation& at, const Y& force, const Y& lambda, Y& left) const {
    left = -force - at.r * lambda[0];
    return left.norm() / (force.norm() + 1);
  }
};
struct WrongVelocityRow : SphericalPendulum<double> {
  Violation<double> velocity_rows(const Evaluation& at, Y& phi_dot) const {
    phi_dot.setConstant(1, 2 * at.r.dot(at.v));
    return {};
  }
};
struct WrongSolution : SphericalPendulum<double> {
  using SphericalPendulum<double>::solve;
  void solve(const Factors& factors, const Evaluation& at, const Y& left, const Y& rows, Y& x, Y& mu) const {
    SphericalPendulum<double>::solve(factors, at, left, rows, x, mu);
    mu[0] *= 1 + 1e-6;
  }
};
struct RemembersTheLast : SphericalPendulum<double> {
  Evaluation last;
  void evaluate(const double&, const Y& y, Evaluation& at) {
    at = {y.head(3), y.tail(3)};
    last = at;
  }
  double residual(const Evaluation&, const Y& force, const Y& lambda, Y& left) const {
    return SphericalPendulum<double>::residual(last, force, lambda, left);
  }
};
struct KeepsNoMatrix : SphericalPendulum<double> {
  void correct_positions(double t, Y& y, bool factor) {
    if (factor) SphericalPendulum<double>::correct_positions(t, y, true);
  }
};
struct WeighsTwice : SphericalPendulum<double> {
  void applied_force(const Evaluation& at, Y& force) const {
    SphericalPendulum<double>::applied_force(at, force);
    force *= 2;
  }
};
struct HasTooFewSizes : SphericalPendulum<double> {
  void position_sizes(const Y&, Y& sizes) const { sizes.setOnes(1); }
};
struct AddsToWhatHasNoRows : SphericalPendulum<double> {
  bool normalise_step(double, Y&, Y& v_dot) const {
    v_dot *= 2;
    return false;
  }
};
struct SeesNothingOff : SphericalPendulum<double> {
  Violation<double> position_violation(double, const Y&) const { return {}; }
  Violation<double> position_rows(const Evaluation& at, Y& phi) const {
    SphericalPendulum<double>::position_rows(at, phi);
    return {};
  }
};
struct SeesNoImbalance : SphericalPendulum<double> {
  double residual(const Evaluation& at, const Y& force, const Y& lambda, Y& left) const {
    SphericalPendulum<double>::residual(at, force, lambda, left);
    return 0;
  }
};
struct GrowsElsewhere : SphericalPendulum<double> {
  void displacement_rate(const Y& by, const Y& velocity, Y& rate) const { rate = (1 + by.norm()) * velocity; }
};
struct ChangesWhatItAccepts : SphericalPendulum<double> {
  bool accept_state(double, Y& y) const {
    y *= 2;
    return false;
  }
};
template <class Model>
class ABrokenModel : public testing::Test {};
using BrokenModels =
    testing::Types<AddsTwice, CorrectsBackwards, ForgetsGravity, WrongVelocityRow, WrongSolution,
                   RemembersTheLast, KeepsNoMatrix, WeighsTwice, HasTooFewSizes, AddsToWhatHasNoRows,
                   SeesNothingOff, SeesNoImbalance, GrowsElsewhere, ChangesWhatItAccepts>;
TYPED_TEST_SUITE(ABrokenModel, BrokenModels);

TYPED_TEST(ABrokenModel, IsFoundByTheLaws) {
  TypeParam model;
  EXPECT_FALSE(broken_laws(model, 0.0, model.start()).empty());
}

}  // namespace
}  // namespace trivium::integrators
