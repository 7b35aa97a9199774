#pragma once
/// A dense symmetric system K x = b, as the printed matrices are. It is equilibrated, factored by LU with
/// partial pivoting, and refined with residuals in working precision (Higham, Accuracy and Stability of
/// Numerical Algorithms, 2002, chapter 12).

#include <memory>

#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// Compiled in instances/, for float to Real50.
template <class Scalar>
class DenseSolver {
 public:
  /// Factors a symmetric K.
  explicit DenseSolver(MatrixX<Scalar> K);
  ~DenseSolver();
  DenseSolver(DenseSolver&&) noexcept;
  DenseSolver& operator=(DenseSolver&&) noexcept;

  /// K x = b, refined until the correction no longer shrinks, at most three times.
  VectorX<Scalar> solve(const VectorX<Scalar>& b) const;
  /// One forward and back substitution, unrefined.
  VectorX<Scalar> substitute(const VectorX<Scalar>& b) const;

 private:
  struct Factor;
  MatrixX<Scalar> K_;
  VectorX<Scalar> scale_;
  std::unique_ptr<Factor> factor_;
};

}  // namespace trivium
