#pragma once
/// Generalised conjugate residuals (Eisenstat, Elman and Schultz, SIAM Journal on Numerical Analysis 20,
/// 1983) for one matrix and many right sides. Radau's stages use the method to solve for their springs.

#include <array>

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// Search directions and their images under the matrix, kept for all right sides: a later right side starts
/// with the directions of the earlier ones.
template <class S>
class ConjugateResiduals {
 public:
  /// Forgets all directions: for another matrix.
  void clear() { kept_ = 0; }

  /// Moves x along the kept directions so that the residual becomes minimal.
  template <class X>
  void reduce(StateVector<S>& residual, X&& x) const {
    for (int k = 0; k < held(); ++k) {
      const S share = images_[k].dot(residual);
      residual -= share * images_[k];
      x -= share * directions_[k];
    }
  }
  /// Keeps a direction, which changes the residual by `image`. Returns false if the image is a linear
  /// combination of those kept.
  bool keep(StateVector<S>& direction, StateVector<S>& image) {
    const S size = image.norm();
    for (int k = 0; k < held(); ++k) {
      const S share = images_[k].dot(image);
      image -= share * images_[k];
      direction -= share * directions_[k];
    }
    const S left = image.norm();
    if (!(left > S(known_share) * size)) return false;
    const int at = kept_++ % most;
    images_[at] = image / left;
    directions_[at] = direction / left;
    return true;
  }

 private:
  /// Number of directions that are kept; the oldest is overwritten. Chosen by experiment: more directions
  /// cost memory and time for every right side, fewer lose directions that later right sides need.
  static constexpr int most = 12;
  /// An image counts as linearly dependent if orthogonalisation leaves less than this share of it: half of a
  /// double's digits are then rounding.
  static constexpr double known_share = 1e-8;

  int held() const { return kept_ < most ? kept_ : most; }

  std::array<StateVector<S>, most> directions_, images_;
  int kept_ = 0;
};

}  // namespace trivium::integrators
