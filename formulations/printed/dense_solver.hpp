#pragma once
/// A dense symmetric system K x = b, such as the printed equations. The matrix is equilibrated and factored
/// by LU with partial pivoting. Solutions are refined with residuals in working precision (Higham, Accuracy
/// and Stability of Numerical Algorithms, 2002, chapter 12).

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

  /// Solves K x = b with at most three steps of refinement. A correction that is not smaller than half of the
  /// one before counts as rounding error: it is not added, and the refinement ends.
  VectorX<Scalar> solve(const VectorX<Scalar>& b) const;
  /// Forward and back substitution without refinement.
  VectorX<Scalar> substitute(const VectorX<Scalar>& b) const;

 private:
  struct Factor;
  MatrixX<Scalar> K_;
  VectorX<Scalar> scale_;
  std::unique_ptr<Factor> factor_;
};

}  // namespace trivium
