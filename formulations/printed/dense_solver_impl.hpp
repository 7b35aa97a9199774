#pragma once
/// The definition of DenseSolver. Each Scalar has its own translation unit, because the LU templates are
/// expensive to compile.

#include <Eigen/LU>
#include <cmath>

#include "formulations/printed/dense_solver.hpp"

namespace trivium {

/// LU factors, with partial pivoting, of the scaled matrix.
template <class Scalar>
struct DenseSolver<Scalar>::Factor {
  Eigen::PartialPivLU<MatrixX<Scalar>> lu;
};

namespace detail {

/// Scales K symmetrically so that the largest entry of each row and column is near 1 (Ruiz 2001). The factors
/// are powers of two, so the scaling causes no rounding. A sweep halves the exponents, and ten sweeps bring
/// entries of 2^1000 near 1.
template <class Scalar>
VectorX<Scalar> equilibrate(MatrixX<Scalar>& K) {
  using std::frexp, std::ldexp, std::abs;
  VectorX<Scalar> scale = VectorX<Scalar>::Ones(K.rows());
  for (int sweep = 0; sweep < 10; ++sweep) {
    bool changed = false;
    VectorX<Scalar> step(K.rows());
    for (Eigen::Index k = 0; k < K.rows(); ++k) {
      const Scalar largest = K.col(k).cwiseAbs().maxCoeff();
      int exponent = 0;
      if (largest > Scalar(0)) frexp(largest, &exponent);
      const int half = exponent / 2;
      step[k] = ldexp(Scalar(1), -half);
      changed = changed || half != 0;
    }
    if (!changed) break;
    K = step.asDiagonal() * K * step.asDiagonal();
    scale = scale.cwiseProduct(step);
  }
  return scale;
}

}  // namespace detail

template <class Scalar>
DenseSolver<Scalar>::DenseSolver(MatrixX<Scalar> K) : K_(std::move(K)), factor_(std::make_unique<Factor>()) {
  scale_ = detail::equilibrate(K_);
  if (K_.rows() > 0) factor_->lu.compute(K_);
}
template <class Scalar>
DenseSolver<Scalar>::~DenseSolver() = default;
template <class Scalar>
DenseSolver<Scalar>::DenseSolver(DenseSolver&&) noexcept = default;
template <class Scalar>
DenseSolver<Scalar>& DenseSolver<Scalar>::operator=(DenseSolver&&) noexcept = default;

template <class Scalar>
VectorX<Scalar> DenseSolver<Scalar>::solve(const VectorX<Scalar>& b) const {
  if (K_.rows() == 0) return b;
  const VectorX<Scalar> c = scale_.cwiseProduct(b);
  VectorX<Scalar> x = factor_->lu.solve(c);
  Scalar last = x.norm();
  // One step usually reduces the residual to rounding. The others are for matrices whose condition number
  // approaches 1 / u, where each step corrects few digits. Three is chosen by experiment: fewer leave digits
  // there, more cost time without a gain.
  for (int step = 0; step < 3; ++step) {
    const VectorX<Scalar> correction = factor_->lu.solve(c - K_ * x);
    const Scalar size = correction.norm();
    if (!(size < last / 2)) break;
    x += correction;
    last = size;
  }
  return scale_.cwiseProduct(x);
}

template <class Scalar>
VectorX<Scalar> DenseSolver<Scalar>::substitute(const VectorX<Scalar>& b) const {
  if (K_.rows() == 0) return b;
  return scale_.cwiseProduct(factor_->lu.solve(scale_.cwiseProduct(b)));
}

}  // namespace trivium
