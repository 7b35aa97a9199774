#pragma once
/// Anderson's acceleration of an iteration that a matrix all but solves (Anderson, Journal of the ACM 12,
/// 1965). Newton's matrices leave gyroscopic and geometric terms out; the last few changes tell what these
/// do.

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <limits>

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// What the matrix leaves out (gyroscopic terms above all) turns one change into the next, and the last few
/// tell how. The step is that of the mixture whose change is least, in its first `measured` numbers.
template <class S>
class Anderson {
 public:
  /// Of another iteration, or another matrix.
  void clear() { kept_ = 0; }

  /// What to add where the matrix would add `change`.
  const StateVector<S>& step(const StateVector<S>& change, Eigen::Index measured) {
    if (kept_ > 0) {
      // the last step and what became of its change
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
      // what is rounding beside the largest says nothing
      products.diagonal().array() +=
          products.diagonal().maxCoeff() * S(1e-13) + std::numeric_limits<S>::min();
      const auto shares = products.ldlt().solve(sides).eval();
      for (int a = 0; a < n; ++a) step_ -= shares[a] * (steps_[a] + turns_[a]);
    }
    before_ = change;
    ++kept_;
    return step_;
  }

 private:
  static constexpr int depth = 3;
  StateVector<S> before_, step_;
  std::array<StateVector<S>, depth> steps_, turns_;
  Eigen::Matrix<S, depth, depth> products_ =
      Eigen::Matrix<S, depth, depth>::Zero();  ///< of turns with each other
  int kept_ = 0;
};

}  // namespace trivium::integrators
