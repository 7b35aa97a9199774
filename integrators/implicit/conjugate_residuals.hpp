#pragma once
/// Generalised conjugate residuals (Eisenstat, Elman and Schultz, SIAM Journal on Numerical Analysis 20,
/// 1983) for one matrix and many right sides. Radau's stages solve for their springs by it.

#include <array>

#include "integrators/contract/state_vector.hpp"

namespace trivium::integrators {

/// Directions whose effect on a residual is known: what one right side paid for, the next ones have.
template <class S>
class ConjugateResiduals {
 public:
  /// Of another matrix.
  void clear() { kept_ = 0; }

  /// Moves x along all directions to where the residual is least.
  template <class X>
  void reduce(StateVector<S>& residual, X&& x) const {
    for (int k = 0; k < held(); ++k) {
      const S share = images_[k].dot(residual);
      residual -= share * images_[k];
      x -= share * directions_[k];
    }
  }
  /// A step by `direction` changes the residual by `image`. Returns whether that was not known yet.
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
  static constexpr int most = 12;  ///< the oldest go
  /// An image of which no more is left beside those held is known: half of a double's digits are rounding.
  static constexpr double known_share = 1e-8;

  int held() const { return kept_ < most ? kept_ : most; }

  std::array<StateVector<S>, most> directions_, images_;
  int kept_ = 0;
};

}  // namespace trivium::integrators
