/// The laws of Anderson acceleration and of generalised conjugate residuals.

#include <gtest/gtest.h>

#include <cmath>

#include "integrators/implicit/anderson.hpp"
#include "integrators/implicit/conjugate_residuals.hpp"

namespace trivium::integrators {

namespace {

using Matrix = Eigen::Matrix3d;

const Matrix matrix{{4, 1, -2}, {0.5, 3, 1}, {-1, 2, 5}};

/// Solves matrix x = right_side along the known directions first and along new ones where needed. Returns the
/// number of new directions.
int solve(ConjugateResiduals<double>& known, const StateVector<double>& right_side, StateVector<double>& x) {
  x = StateVector<double>::Zero(3);
  StateVector<double> residual = -right_side;
  known.reduce(residual, x);
  int added = 0;
  while (residual.norm() > 1e-12 * right_side.norm()) {
    StateVector<double> direction = residual, image = matrix * direction;
    if (!known.keep(direction, image)) break;
    known.reduce(residual, x);
    ++added;
  }
  return added;
}

}  // namespace

TEST(ConjugateResiduals, SolveInNoMoreDirectionsThanUnknowns) {
  ConjugateResiduals<double> known;
  const StateVector<double> right_side = Eigen::Vector3d(1, -2, 3);
  StateVector<double> x;
  EXPECT_LE(solve(known, right_side, x), 3);
  EXPECT_LT((matrix * x - right_side).norm(), 1e-11);
}

TEST(ConjugateResiduals, WhatOneRightSidePaidForTheNextOnesHave) {
  ConjugateResiduals<double> known;
  StateVector<double> x;
  ASSERT_EQ(solve(known, Eigen::Vector3d(1, -2, 3), x), 3);
  const StateVector<double> next = Eigen::Vector3d(-5, 1, 0.5);
  EXPECT_EQ(solve(known, next, x), 0);
  EXPECT_LT((matrix * x - next).norm(), 1e-11);
}

TEST(ConjugateResiduals, ForgetAnotherMatrix) {
  ConjugateResiduals<double> known;
  StateVector<double> x;
  solve(known, Eigen::Vector3d(1, -2, 3), x);
  known.clear();
  StateVector<double> residual = Eigen::Vector3d(1, 1, 1);
  x.setZero();
  known.reduce(residual, x);
  EXPECT_EQ(x.norm(), 0);
}

TEST(ConjugateResiduals, KeepNoDirectionTwice) {
  ConjugateResiduals<double> known;
  StateVector<double> direction = Eigen::Vector3d(1, 0, 0), image = matrix * direction;
  EXPECT_TRUE(known.keep(direction, image));
  direction = Eigen::Vector3d(2, 0, 0);
  image = matrix * direction;
  EXPECT_FALSE(known.keep(direction, image));
}

// For x = g(x) with a linear g in n unknowns the change is zero after n differences are known. The bound is
// the root of the regularisation, which is 1e-13 of the squared differences.
TEST(Anderson, EndsALinearIterationInAsManyStepsAsItHasUnknowns) {
  const Matrix g = 0.2 * matrix;
  const Eigen::Vector3d c(1, 2, 3);
  Anderson<double> anderson;
  StateVector<double> x = StateVector<double>::Zero(3), change;
  for (int k = 0; k < 4; ++k) {
    change = g * x + c - x;
    x += anderson.step(change, 3);
  }
  change = g * x + c - x;
  EXPECT_LT(change.norm(), std::sqrt(1e-13) * c.norm());
}

// Where an iteration stands still, the differences of changes are rounding, and tell nothing of where to go.
TEST(Anderson, TakesNoLargeStepFromDifferencesOfRounding) {
  Anderson<double> anderson;
  const StateVector<double> change = Eigen::Vector3d(1e-8, -2e-8, 3e-8);
  anderson.step(change, 3);
  const StateVector<double> again = change * (1 + 1e-15);
  EXPECT_LT(anderson.step(again, 3).norm(), 1000 * change.norm());
}

}  // namespace trivium::integrators
