#pragma once
/// Anderson acceleration of a fixed-point iteration (Anderson, Journal of the ACM 12, 1965). Newton's
/// matrices here leave out gyroscopic and geometric terms. The change of an iteration is therefore nearly a
/// linear function of the change before it, and a combination of the last few changes removes most of the
/// error.

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <limits>

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// Let f_k be the change that the matrix gives in iteration k and dx_k the step taken. The accelerated step
/// is f_k - sum w_j (dx_j + df_j) with df_j = f_j+1 - f_j, over the last three j. The weights w minimise the
/// norm of f_k - sum w_j df_j in its first `measured` numbers.
template <class S>
class Anderson {
 public:
  /// Forgets all changes. Call it before the iteration of another step. Call it also when a matrix that
  /// served several iterates is replaced, because the kept changes belong to that matrix. If every iterate
  /// has a matrix of its own, do not call it within the iteration.
  void clear() { kept_ = 0; }

  /// The accelerated step, in place of the step `change` by the matrix alone.
  const StateVector<S>& step(const StateVector<S>& change, Eigen::Index measured) {
    if (kept_ > 0) {
      // the previous step, and the difference between its change and this one
      const int at = (kept_ - 1) % depth;
      steps_[at].swap(step_);
      turns_[at] = change - before_;
      for (int a = 0; a < std::min(kept_, depth); ++a)
        products_(a, at) = products_(at, a) = turns_[a].head(measured).dot(turns_[at].head(measured));
    }
    step_ = change;
    if (const int n = std::min(kept_, depth); n > 0) {
      Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, 0, depth, depth> products =
          products_.topLeftCorner(n, n);
      Eigen::Matrix<S, Eigen::Dynamic, 1, 0, depth, 1> sides(n);
      for (int a = 0; a < n; ++a) sides[a] = turns_[a].head(measured).dot(change.head(measured));
      // Regularisation: differences df_j below 3e-7 (the square root of 1e-13) of the largest get almost no
      // weight, as rounding may dominate them. The value is for double; a more precise S keeps it, which can
      // cost iterations but no accuracy.
      products.diagonal().array() +=
          products.diagonal().maxCoeff() * S(1e-13) + std::numeric_limits<S>::min();
      const auto shares = products.ldlt().solve(sides).eval();
      // Larger weights come from changes that differ by rounding alone; 1000 is far above those of iterations
      // that converge.
      if (shares.cwiseAbs().maxCoeff() <= S(1000))
        for (int a = 0; a < n; ++a) step_ -= shares[a] * (steps_[a] + turns_[a]);
    }
    before_ = change;
    ++kept_;
    return step_;
  }

 private:
  /// Number of differences that are combined, chosen by experiment: fewer use less of the past changes, more
  /// cost storage and scalar products.
  static constexpr int depth = 3;
  StateVector<S> before_, step_;
  /// The last steps dx_j, and in turns_ the differences df_j of consecutive changes.
  std::array<StateVector<S>, depth> steps_, turns_;
  Eigen::Matrix<S, depth, depth> products_ =
      Eigen::Matrix<S, depth, depth>::Zero();  ///< scalar products of turns_
  int kept_ = 0;
};

}  // namespace trivium::integrators
