#pragma once
/// What happened to a motion beside its steps: passages through singular positions, and impulses where
/// velocities jump. A passage is decided here: more rows depend on others than at the state before. Impulses
/// are decided and computed in simulation/system/discontinuities.hpp.

#include <cstddef>
#include <utility>
#include <vector>

#include "bodies/rotations/so3.hpp"

namespace trivium {

/// A position where rows depend on others that do not elsewhere.
struct SingularPassage {
  double t;
  int rows;  ///< that depended on others there and before did not
};

/// Velocities jumped with a driver's.
template <class S>
struct Impulse {
  double t;
  VectorX<S> lambda;  ///< of every row: the integral of its multiplier over the jump
};

template <class S>
class MotionLog {
 public:
  /// So many rows were dependent at a state that the motion has reached.
  void note_dependent_rows(const S& t, int count) {
    if (count > dependent_rows_ && dependent_rows_ >= 0 && passages_.size() < most_passages)
      passages_.push_back({static_cast<double>(t), count - dependent_rows_});
    dependent_rows_ = count;
  }
  /// The next state is the first: it is no passage.
  void begin() { dependent_rows_ = -1; }
  void add(Impulse<S> impulse) { impulses_.push_back(std::move(impulse)); }

  /// Positions passed where rows depended on others that do not elsewhere: the dependent rows there
  /// say nothing then, and where a motion could go on in two ways it went as its velocities had it.
  const std::vector<SingularPassage>& passages() const { return passages_; }
  const std::vector<Impulse<S>>& impulses() const { return impulses_; }

 private:
  static constexpr std::size_t most_passages = 1000;
  int dependent_rows_ = -1;  ///< below 0 before the first state
  std::vector<SingularPassage> passages_;
  std::vector<Impulse<S>> impulses_;
};

}  // namespace trivium
