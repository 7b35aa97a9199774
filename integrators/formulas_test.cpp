/// The conditions that give a formula its order.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <type_traits>

#include "integrators/explicit/half_explicit_coefficients.hpp"
#include "integrators/implicit/bdf.hpp"
#include "integrators/implicit/radau_coefficients.hpp"
#include "integrators/methods.hpp"
#include "integrators/testing/toy_systems.hpp"

namespace trivium::integrators {
namespace {

/// The times 0, -1, ... of `n` values, or times of unequal distances.
PolynomialNumbers<double> times(int n, bool are_equal) {
  PolynomialNumbers<double> times;
  for (int k = 0; k < n; ++k) times.add(are_equal ? -k : -k * (1 + 0.3 * k) / 1.3);
  return times;
}

// y = (1 + t)^m
TEST(BackwardFormula, IsExactForPolynomialsOfItsOrderAtAnyDistances) {
  for (const bool are_equal : {true, false})
    for (int order = 1; order <= 5; ++order) {
      const PolynomialNumbers<double> at = times(order + 1, are_equal);
      const BackwardFormula<double> f(at);
      for (int m = 0; m <= order + 1; ++m) {
        double sum = m * f.b;
        for (int j = 0; j < order; ++j) sum += f.c[j] * std::pow(1 + at[j + 1], m);
        if (m <= order)
          EXPECT_NEAR(sum, 1, 1e-13) << order << " " << m;
        else
          EXPECT_GT(std::abs(sum - 1), 1e-3) << order;
      }
    }
}

TEST(BackwardFormula, HasThePublishedCoefficientsAtEqualDistances) {
  const BackwardFormula<double> f(times(4, true));
  EXPECT_NEAR(f.b, 6.0 / 11, 1e-15);
  EXPECT_NEAR(f.c[0], 18.0 / 11, 1e-15);
  EXPECT_NEAR(f.c[1], -9.0 / 11, 1e-15);
  EXPECT_NEAR(f.c[2], 2.0 / 11, 1e-15);
}

TEST(Lagrange, IntegratesPolynomialsThroughItsPointsExactly) {
  for (int n = 1; n <= 6; ++n) {
    const PolynomialNumbers<double> at = times(n, false), weights = integral_weights(at, -1.0, 0.0);
    for (int m = 0; m < n; ++m) {
      double sum = 0;
      for (int j = 0; j < n; ++j) sum += weights[j] * std::pow(1 + at[j], m);
      EXPECT_NEAR(sum, 1.0 / (m + 1), 1e-11) << n << " " << m;
    }
  }
}

TEST(Lagrange, HasTheWeightsOfAdamsAndMoultonAtEqualDistances) {
  const PolynomialNumbers<double> weights = integral_weights(times(4, true), -1.0, 0.0);
  EXPECT_NEAR(weights[0], 9.0 / 24, 1e-15);
  EXPECT_NEAR(weights[1], 19.0 / 24, 1e-15);
  EXPECT_NEAR(weights[2], -5.0 / 24, 1e-15);
  EXPECT_NEAR(weights[3], 1.0 / 24, 1e-15);
}

template <class Stages>
class Radau : public testing::Test {
 protected:
  static constexpr int stages = Stages::value;

  static Eigen::MatrixXd matrix(const std::array<std::array<double, stages>, stages>& rows) {
    Eigen::MatrixXd matrix(stages, stages);
    for (int i = 0; i < stages; ++i)
      for (int j = 0; j < stages; ++j) matrix(i, j) = rows[i][j];
    return matrix;
  }

  const RadauCoefficients<double, stages> radau;
};
using Stages = testing::Types<std::integral_constant<int, 3>, std::integral_constant<int, 5>>;
TYPED_TEST_SUITE(Radau, Stages);

TYPED_TEST(Radau, MeetsTheOrderConditions) {
  constexpr int s = TypeParam::value;
  const auto& r = this->radau;
  const auto quadrature = [&](int i, int q) {
    double sum = 0;
    for (int j = 0; j < s; ++j) sum += r.a[i][j] * std::pow(r.c[j], q - 1);
    return sum;
  };
  for (int q = 1; q <= 2 * s - 1; ++q) EXPECT_NEAR(quadrature(s - 1, q), 1.0 / q, 2e-15) << q;
  EXPECT_GT(std::abs(quadrature(s - 1, 2 * s) - 1.0 / (2 * s)), 1e-7);
  for (int i = 0; i < s; ++i)
    for (int q = 1; q <= s; ++q)
      EXPECT_NEAR(quadrature(i, q), std::pow(r.c[i], q) / q, 1e-15) << i << " " << q;
}

TYPED_TEST(Radau, ItsInverseAndSquareAreThoseOfItsMatrix) {
  const Eigen::MatrixXd A = this->matrix(this->radau.a), one = Eigen::MatrixXd::Identity(A.rows(), A.cols());
  EXPECT_LE((A * this->matrix(this->radau.inverse) - one).cwiseAbs().maxCoeff(), 2e-14);
  EXPECT_LE((A * A - this->matrix(this->radau.square)).cwiseAbs().maxCoeff(), 1e-15);
}

TYPED_TEST(Radau, GammaIsTheRealEigenvalueOfItsMatrix) {
  const auto eigenvalues = this->matrix(this->radau.a).eigenvalues();
  int real = 0;
  for (const auto& z : eigenvalues)
    if (std::abs(z.imag()) < 1e-8) {
      ++real;
      EXPECT_NEAR(z.real(), this->radau.gamma, 1e-14);
    }
  EXPECT_EQ(real, 1);
}

// the estimate has order s: it vanishes for polynomials of degree up to s
TYPED_TEST(Radau, ItsErrorEstimateIsOfTheOrderOfItsStages) {
  constexpr int s = TypeParam::value;
  const auto& r = this->radau;
  for (int m = 1; m <= s + 1; ++m) {
    double sum = m == 1 ? r.gamma : 0;  // y = t^m at t = 0 with h = 1
    for (int i = 0; i < s; ++i) sum += r.error[i] * std::pow(r.c[i], m);
    if (m <= s)
      EXPECT_NEAR(sum, 0, 1e-15) << m;
    else
      EXPECT_GT(std::abs(sum), 1e-5);
  }
}

// Hairer and Wanner (1996), IV.5 and IV.8
TEST(RadauOfThreeStages, HasItsPublishedCoefficients) {
  const RadauCoefficients<double, 3> r;
  const double root = std::sqrt(6.0);
  EXPECT_NEAR(r.c[0], (4 - root) / 10, 1e-16);
  EXPECT_NEAR(r.a[0][0], (88 - 7 * root) / 360, 1e-16);
  EXPECT_NEAR(r.gamma, (6 + std::cbrt(81.0) - std::cbrt(9.0)) / 30, 1e-16);
  const std::array<double, 3> error{-13 - 7 * root, -13 + 7 * root, -1};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(r.error[i], r.gamma / 3 * error[i], 1e-15) << i;
}

// The order conditions of Hairer, Norsett, Wanner (1993), II.2. In addition, index 2 requires order 2 of the
// stages after the second.
TEST(HalfExplicit, MeetsTheOrderConditionsOfFour) {
  const Hem4Coefficients<double> m;
  Eigen::MatrixXd A(5, 5);
  Eigen::VectorXd b(5), c(5);
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) A(i, j) = m.a[i][j];
    b[i] = m.a[5][i];
    c[i] = m.c[i];
  }
  EXPECT_LE((A.rowwise().sum() - c).norm(), 1e-14);
  for (int i = 2; i < 5; ++i) EXPECT_NEAR(A.row(i).dot(c), c[i] * c[i] / 2, 1e-14) << i;
  for (int q = 1; q <= 5; ++q) EXPECT_NEAR(b.dot(c.array().pow(q - 1).matrix()), 1.0 / q, 1e-14) << q;
  EXPECT_NEAR(b.dot(A * c), 1.0 / 6, 1e-14);
  EXPECT_NEAR(b.dot(c.cwiseProduct(A * c)), 1.0 / 8, 1e-14);
  EXPECT_NEAR(b.dot(A * c.cwiseAbs2()), 1.0 / 12, 1e-14);
  EXPECT_NEAR(b.dot(A * (A * c)), 1.0 / 24, 1e-14);
}

// Conditions sum a_ij c_j^(q-1) = c_i^q / q: q = 1 for all rows and q = 2 from the third row on; q = 3 for
// the row of the step and the row at 19/20; up to q = 5 for the step and up to q = 4 for the embedded
// formula.
TEST(HalfExplicit, HoldsDormandAndPrincesFormulaAndARowBeyondIt) {
  const Hedop5Coefficients<double> m;
  const auto misses = [&](const auto& row, double c, int q) {
    double sum = 0;
    for (int j = 0; j < 7; ++j) sum += row[j] * std::pow(m.c[j], q - 1);
    return std::abs(sum - std::pow(c, q) / q);
  };
  for (int i = 1; i < 8; ++i) EXPECT_LE(misses(m.a[i], m.c[i], 1), 1e-14) << i;
  for (int i = 2; i < 8; ++i) EXPECT_LE(misses(m.a[i], m.c[i], 2), 1e-14) << i;
  for (int i = 6; i < 8; ++i) EXPECT_LE(misses(m.a[i], m.c[i], 3), 1e-14) << i;
  for (int q = 4; q <= 5; ++q) EXPECT_LE(misses(m.a[6], 1, q), 1e-14) << q;
  for (int q = 1; q <= 4; ++q) EXPECT_LE(misses(m.embedded, 1, q), 1e-14) << q;
  EXPECT_GE(misses(m.embedded, 1, 5), 1e-4);
}

TEST(ImplicitMethods, RefuseASystemWithoutItsConstraints) {
  const auto expect_refusal = [](const char* name, Steps steps) {
    test::OnACircle system;
    SystemAdapter<test::OnACircle> erased(system);
    const auto method = make_method<double>(name, steps, {});
    double t = 0;
    StateVector<double> y = system.start();
    EXPECT_THROW(method->step(erased, t, y, 0.1), UsageError) << name;
  };
  for (const char* name : {"generalized-alpha", "generalized-alpha-gl2", "hht", "bdf", "rattle", "radau5",
                           "radau9", "hem4", "hedop5"})
    expect_refusal(name, Steps::given);
  for (const char* name : {"radau5", "radau9", "cvode-bdf", "arkode-dirk", "ida"})
    expect_refusal(name, Steps::chosen);
}

TEST(ImplicitMethods, RefuseParametersThatAreNotTheirs) {
  const auto make = [](const char* name, const MethodParameters& given) {
    make_method<double>(name, Steps::given, {}, given);
  };
  EXPECT_NO_THROW(make("bdf", {.order = 5}));
  EXPECT_THROW(make("bdf", {.order = 6}), UsageError);
  EXPECT_THROW(make("bdf", {.order = 0}), UsageError);
  EXPECT_THROW(make("hht", {.order = 2}), UsageError);
  EXPECT_NO_THROW(make("generalized-alpha-gl2", {.rho = 1.0}));
  EXPECT_THROW(make("generalized-alpha", {.rho = 1.1}), UsageError);
  EXPECT_THROW(make("hht", {.alpha = 0.1}), UsageError);
  EXPECT_THROW(make("dopri5", {.full_newton = true}), UsageError);
  EXPECT_THROW(make("rattle", {.full_newton = true}), UsageError);
  EXPECT_NO_THROW(make("arkode-erk", {.order = 8}));
  EXPECT_THROW(make("arkode-erk", {.order = 7}), UsageError);
  EXPECT_THROW(make("arkode-dirk", {.order = 6}), UsageError);
}

}  // namespace
}  // namespace trivium::integrators
