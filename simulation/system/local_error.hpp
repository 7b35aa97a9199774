#pragma once
/// An estimate of the error that every step of a method with given steps commits. It asks nothing of the
/// method: with the accelerations a at the last states, the formula of Adams and Moulton of one order more
/// than the method's gives the end of the step again,
///
///     v_n+1 = v_n + h sum_j beta_j a_n+1-j,   r_n+1 = r_n + h sum_j beta_j v_n+1-j
///     A_n+1 = A_n exp(h sum_j beta_j omega_bar_n+1-j + h^2/12 omega_bar_n x omega_bar_n+1)
///
/// (Magnus' expansion, of order 4). The differences from the method's own numbers are its local errors. They
/// count as errors of the points of a body: an angle is multiplied by the reach of the body
/// (mechanism/reach.hpp). lambda does not enter.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "bodies/rotations/so3.hpp"
#include "integrators/lagrange.hpp"

namespace trivium {

/// What a body does at the end of a step.
template <class S>
struct BodyInMotion {
  Vector3<S> r, v, a;                   ///< position [m], velocity [m/s], acceleration [m/s^2], global
  Matrix3<S> A;                         ///< rotation matrix
  Vector3<S> omega_bar, omega_bar_dot;  ///< [rad/s, rad/s^2], body frame
};

/// Sums of local errors over the steps of a motion, for the points of the body that errs most.
struct LocalErrorSums {
  double position = 0;  ///< [m]
  double velocity = 0;  ///< [m/s]
  long steps = 0;       ///< in the sums; the first steps, which have too few states before them, are left out
};

/// Sums the local errors of a motion, body by body. Methods of the orders 1 to 3 are estimated: at usual
/// steps their errors are the largest.
template <class S>
class LocalError {
 public:
  static constexpr int highest_order = 3;

  /// `order` of the method, 1 to 3. `reach` of each body: how far its points move by a rotation of 1 rad [m].
  LocalError(int order, std::vector<S> reach)
      : order_(order), reach_(std::move(reach)), sums_(reach_.size()) {
    integrators::PolynomialNumbers<S> ends;  // of the last steps, in steps
    for (int j = 0; j <= order; ++j) ends.add(S(-j));
    beta_ = integral_weights(ends, S(-1), S(0));
  }

  /// The motion is not smooth at the last state: earlier ones are forgotten.
  void restart() { known_ = std::min(known_, 1); }

  /// Adds the end of a step of length h [s]; the first state has no step. A step of another length restarts;
  /// a relative change of h by 1e-6 changes the estimate as little, and is far above the rounding of times.
  void add(std::vector<BodyInMotion<S>>& bodies, const S& h) {
    using std::abs;
    if (known_ > 1 && !(abs(h - h_) <= S(1e-6) * h)) restart();
    h_ = h;
    std::rotate(past_.begin(), past_.end() - 1, past_.end());
    past_[0].swap(bodies);
    if (++known_ <= order_) return;
    known_ = order_ + 1;
    for (std::size_t b = 0; b < sums_.size(); ++b) measure(b);
    ++steps_;
  }

  LocalErrorSums sums() const {
    LocalErrorSums largest{0, 0, steps_};
    for (const auto& [position, velocity] : sums_) {
      raise(largest.position, static_cast<double>(position));
      raise(largest.velocity, static_cast<double>(velocity));
    }
    return largest;
  }

 private:
  void measure(std::size_t b) {
    using B = BodyInMotion<S>;
    const auto integral = [&](Vector3<S> B::*rate) {
      Vector3<S> sum = Vector3<S>::Zero();
      for (int j = 0; j <= order_; ++j) sum += beta_[j] * (past_[j][b].*rate);
      return Vector3<S>(h_ * sum);
    };
    const B &now = past_[0][b], &before = past_[1][b];
    const Vector3<S> turn = integral(&B::omega_bar) + h_ * h_ / 12 * before.omega_bar.cross(now.omega_bar);
    const Matrix3<S> off =
        rotation_matrix(exponential_parameters(turn)).transpose() * before.A.transpose() * now.A;
    const Vector3<S> angle(off(2, 1) - off(1, 2), off(0, 2) - off(2, 0),
                           off(1, 0) - off(0, 1));  // 2 sin(angle) axis
    sums_[b].first += (now.r - before.r - integral(&B::v)).norm() + reach_[b] * angle.norm() / 2;
    sums_[b].second += (now.v - before.v - integral(&B::a)).norm() +
                       reach_[b] * (now.omega_bar - before.omega_bar - integral(&B::omega_bar_dot)).norm();
  }

  int order_, known_ = 0;
  long steps_ = 0;
  S h_{0};
  integrators::PolynomialNumbers<S> beta_;  ///< of Adams and Moulton, the latest value first
  std::vector<S> reach_;
  std::array<std::vector<BodyInMotion<S>>, highest_order + 1> past_;  ///< the latest first
  std::vector<std::pair<S, S>> sums_;  ///< per body: of positions [m], of velocities [m/s]
};

}  // namespace trivium
