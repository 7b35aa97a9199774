#pragma once
/// Events of a motion: passages through singular positions, and impulses at jumps of velocities. Impulses are
/// computed in simulation/system/discontinuities.hpp.

#include <cstddef>
#include <utility>
#include <vector>

#include "bodies/rotations/so3.hpp"

namespace trivium {

/// A singular position: some rows are dependent here that are independent at other positions of the motion.
struct SingularPassage {
  double t;  ///< [s]
  int rows;  ///< number of rows that became dependent
};

/// The impulses of the rows at a jump of velocities, which a kink of a driver's function causes.
template <class S>
struct Impulse {
  double t;           ///< [s]
  VectorX<S> lambda;  ///< per row: integral of its multiplier over the jump
};

/// The events of one motion. A state is a passage if more rows are dependent there than at the accepted state
/// before.
template <class S>
class MotionLog {
 public:
  /// Notes the number of dependent rows at an accepted state.
  void note_dependent_rows(const S& t, int count) {
    if (count > dependent_rows_ && dependent_rows_ >= 0 && passages_.size() < most_passages)
      passages_.push_back({static_cast<double>(t), count - dependent_rows_});
    dependent_rows_ = count;
  }
  /// Begins a motion: its first state cannot be a passage.
  void begin() { dependent_rows_ = -1; }
  void add(Impulse<S> impulse) { impulses_.push_back(std::move(impulse)); }

  /// The passages so far, at most most_passages. At a passage the dependent rows are left out; where the
  /// motion can branch, it goes in the direction of its velocities.
  const std::vector<SingularPassage>& passages() const { return passages_; }
  const std::vector<Impulse<S>>& impulses() const { return impulses_; }

 private:
  /// bounds the memory of a run that stays near singular positions
  static constexpr std::size_t most_passages = 1000;
  int dependent_rows_ = -1;  ///< number at the last accepted state; -1 before the first
  std::vector<SingularPassage> passages_;
  std::vector<Impulse<S>> impulses_;
};

}  // namespace trivium
