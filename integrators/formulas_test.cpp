/// The laws that make a formula one of its order.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "integrators/bdf.hpp"
#include "integrators/half_explicit.hpp"
#include "integrators/methods.hpp"
#include "integrators/radau.hpp"
#include "integrators/test_systems.hpp"

namespace trivium::integrators {
namespace {

// y = t^m, y_n+1 at t = 1 and steps of 1
TEST(BackwardFormula, IsExactForPolynomialsOfItsOrder) {
  for (int order = 1; order <= 5; ++order) {
    const BackwardFormula f = BackwardFormula::of_order(order);
    for (int m = 0; m <= order + 1; ++m) {
      double sum = m * f.b;
      for (int j = 0; j < order; ++j) sum += f.c[j] * std::pow(-j, m);
      if (m <= order)
        EXPECT_EQ(sum, f.divisor) << order << " " << m;
      else
        EXPECT_NE(sum, f.divisor) << order;
    }
  }
}

TEST(Radau, MeetsTheOrderConditionsOfFive) {
  const RadauCoefficients<double> r;
  for (int q = 1; q <= 5; ++q) {
    double sum = 0;
    for (int j = 0; j < 3; ++j) sum += r.a[2][j] * std::pow(r.c[j], q - 1);
    EXPECT_NEAR(sum, 1.0 / q, 1e-15) << q;
  }
  for (int i = 0; i < 3; ++i)
    for (int q = 1; q <= 3; ++q) {
      double sum = 0;
      for (int j = 0; j < 3; ++j) sum += r.a[i][j] * std::pow(r.c[j], q - 1);
      EXPECT_NEAR(sum, std::pow(r.c[i], q) / q, 1e-15) << i << " " << q;
    }
}

TEST(Radau, ItsInverseIsThatOfItsMatrix) {
  const RadauCoefficients<double> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double product = 0;
      for (int k = 0; k < 3; ++k) product += r.a[i][k] * r.inverse[k][j];
      EXPECT_NEAR(product, i == j, 1e-14);
    }
}

TEST(Radau, ItsSquareIsThatOfItsMatrixAndGammaItsRealEigenvalue) {
  const RadauCoefficients<double> r;
  Eigen::Matrix3d A;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) A(i, j) = r.a[i][j];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(r.square[i][j], (A * A)(i, j), 1e-15);
  EXPECT_NEAR((A - r.gamma * Eigen::Matrix3d::Identity()).determinant(), 0, 1e-16);
}

// the estimate is of order 3: it sees nothing of a polynomial of degree 3
TEST(Radau, ItsErrorEstimateIsOfOrderThree) {
  const RadauCoefficients<double> r;
  for (int m = 1; m <= 4; ++m) {
    double sum = m == 1 ? r.gamma : 0;  // y = t^m from t = 0, in a step of 1
    for (int i = 0; i < 3; ++i) sum += r.error[i] * std::pow(r.c[i], m);
    if (m <= 3)
      EXPECT_NEAR(sum, 0, 1e-15) << m;
    else
      EXPECT_GT(std::abs(sum), 1e-3);
  }
}

// Hairer, Norsett, Wanner (1993), II.2; and stages behind the second are of order 2, as index 2 asks
TEST(HalfExplicit, MeetsTheOrderConditionsOfFour) {
  const Hem4Coefficients<double> m;
  Eigen::Matrix<double, 5, 5> A;
  Eigen::Matrix<double, 5, 1> b, c;
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

// every row is a quadrature of its c, from the third on of order 2; those of the step and of the multipliers'
// rows beyond it of order 3, and the step's own of 5, the embedded one's of 4
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
    Erased<test::OnACircle> erased(system);
    const auto method = make_method<double>(name, steps, {});
    double t = 0;
    Flat<double> y = system.start();
    EXPECT_THROW(method->step(erased, t, y, 0.1), UsageError) << name;
  };
  for (const char* name :
       {"generalized-alpha", "generalized-alpha-gl2", "hht", "bdf", "rattle", "radau5", "hem4", "hedop5"})
    expect_refusal(name, Steps::given);
  for (const char* name : {"radau5", "cvode-bdf", "arkode-dirk", "ida"}) expect_refusal(name, Steps::chosen);
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
