#pragma once
/// An estimate of the error that every step of a method with given steps commits. It asks nothing of the
/// method. An exact motion satisfies, up to a high power of h, formulas that relate the positions, velocities
/// and accelerations at the ends of a few steps. The states of a method leave a remainder: its errors in
/// these steps, or a mean of them. The formulas are so much more accurate than the method that their own
/// errors are small beside it at usual steps. (Where a motion changes much within a step, such as a stiff
/// spring that has just been released, the remainder is larger than the error.)
///
/// Rotations are measured by Euler parameters p of what is left beside an even rotation,
///
///     A_j = A_m exp((j - m) h tilde(omega_bar_m)) A(p),   m a state in the middle,
///
/// so that a fast even spin, which many methods integrate exactly, has no remainder.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "bodies/rotations/so3.hpp"
#include "simulation/system/error_sums.hpp"

namespace trivium {

/// A formula that polynomials x(t) satisfy at times h t_j, with t_j = j if they are h apart,
///
///     sum_j of_x_j x_j + h of_rate_j x'_j + h^2 of_second_j x''_j = 0.
///
/// It is the divided difference of x that takes time j n_j-fold, n_j = 1, 2 or 3, so that x'_j and x''_j have
/// weights only if n_j exceeds 1 and 2. All polynomials of a degree below sum_j n_j - 1 satisfy it. It is
/// scaled such that an error e of x in every step leaves the remainder e.
template <class S>
struct StepFormula {
  std::vector<int> n;
  std::vector<S> at;  ///< t_j
  std::vector<S> of_x, of_rate, of_second;

  explicit StepFormula(const std::vector<int>& repeated) : StepFormula(repeated, evenly(repeated.size())) {}
  StepFormula(std::vector<int> repeated, std::vector<S> apart)
      : n(std::move(repeated)), at(std::move(apart)) {
    const int times = static_cast<int>(n.size());
    S scale(0);
    for (int j = 0; j < times; ++j) {
      S w(1), L(0), Q(0);  // w(t) = product of (t - l)^-n_l at j, and sums of its logarithmic derivatives
      for (int l = 0; l < times; ++l) {
        if (l == j) continue;
        const S inverse = S(1) / S(at[j] - at[l]);
        for (int i = 0; i < n[l]; ++i) w *= inverse;
        L += n[l] * inverse;
        Q += n[l] * inverse * inverse;
      }
      const std::array<S, 3> taylor{w, -L * w, (L * L + Q) * w / 2};  // w(j), w'(j), w''(j) / 2
      of_x.push_back(taylor[n[j] - 1]);
      of_rate.push_back(n[j] > 1 ? taylor[n[j] - 2] : S(0));
      of_second.push_back(n[j] > 2 ? S(taylor[0] / 2) : S(0));
      scale += j * of_x.back();
    }
    for (auto* of : {&of_x, &of_rate, &of_second})
      for (S& weight : *of) weight /= scale;
  }
  int times() const { return static_cast<int>(of_x.size()); }

 private:
  static std::vector<S> evenly(std::size_t times) {
    std::vector<S> at;
    for (std::size_t j = 0; j < times; ++j) at.emplace_back(static_cast<double>(j));
    return at;
  }
};

/// Sums the local errors of a method of order 1 to 5. At the steps for which higher orders are made, no
/// formula over past states is more accurate than they are (see simulation/halved_step_errors.hpp). Every
/// fourth step is estimated, or fewer where states are expensive, so that an estimate costs less than a
/// twentieth of the step. Where the motion begins anew before the formula has enough states, it is a shorter
/// one that needs fewer, also of steps that differ in length; a single step is not estimated.
template <class S>
class LocalError {
 public:
  static constexpr int highest_order = 5;

  /// `order` of the method, 1 to 5; `reach` and `component` of each body as for ErrorSums.
  LocalError(int order, std::vector<S> reach, std::vector<int> component)
      // their remainders have at least one power of h more than the errors of the method
      : positions_(order <= 2 ? std::vector<int>{3, 3} : std::vector<int>{2, 3, 3}),
        velocities_(std::vector<int>((order + 5) / 2, 2)),
        sums_(std::move(reach), std::move(component)),
        past_(velocities_.times()),
        length_(velocities_.times()) {}

  /// The motion begins at this state, or begins anew with other loads or velocities.
  void begin(std::vector<BodyInMotion<S>>& bodies) {
    end();
    known_ = left_out_ = 0;
    keep(bodies, S(0));
  }
  /// The motion, or a part of it before it begins anew, has ended.
  void end() {
    if (!has_estimated_ && since_ >= 3 && since_ <= static_cast<long>(past_.size())) estimate_all();
    has_estimated_ = false;
    since_ = 0;
  }
  /// Whether the end of the next step is left out, and need not be given to `add`.
  bool leaves_out() {
    if (left_out_ == 0) return false;
    --left_out_;
    sums_.step();
    return true;
  }

  /// Adds the end of a step of length h [s]. At a step of another length the states before are forgotten; a
  /// relative change of h by 1e-6 changes the estimate as little, and is far above the rounding of times. If
  /// states are expensive, as many as a formula needs are left out after each estimate.
  void add(std::vector<BodyInMotion<S>>& bodies, const S& h, bool is_expensive) {
    using std::abs;
    if (known_ > 1 && !(abs(h - h_) <= S(1e-6) * h)) known_ = 1;
    sums_.step();
    keep(bodies, h);
    if (known_ < static_cast<int>(past_.size())) return;
    estimate(positions_, velocities_);
    known_ = is_expensive ? 0 : static_cast<int>(past_.size()) - 4;
    left_out_ = is_expensive ? static_cast<int>(past_.size()) : 0;
  }
  const ErrorSums<S>& sums() const { return sums_; }

 private:
  void keep(std::vector<BodyInMotion<S>>& bodies, const S& h) {
    std::rotate(past_.begin(), past_.begin() + 1, past_.end());
    std::rotate(length_.begin(), length_.begin() + 1, length_.end());
    past_.back().swap(bodies);
    length_.back() = h_ = h;
    sums_.see(past_.back());
    ++known_;
    ++since_;
  }
  void estimate(const StepFormula<S>& positions, const StepFormula<S>& velocities) {
    has_estimated_ = true;
    sums_.add([&](int b) { return std::pair(position_error(b, positions), velocity_error(b, velocities)); });
  }
  /// By formulas for all states since the motion began.
  void estimate_all() {
    std::vector<S> at{S(0)};
    for (auto h = length_.end() - since_ + 1; h != length_.end(); ++h) at.push_back(at.back() + *h / h_);
    estimate(StepFormula<S>(positions_.n, {at.end() - positions_.times(), at.end()}),
             StepFormula<S>(std::vector<int>(at.size(), 2), at));
  }
  S position_error(int b, const StepFormula<S>& formula) const {
    const int k = formula.times() - 1, first = static_cast<int>(past_.size()) - 1 - k;
    const BodyInMotion<S>& middle = past_[first + k / 2][b];
    const Vector4<S> back = conjugate_parameters(middle.p);
    Vector3<S> of_r = Vector3<S>::Zero();
    Vector4<S> of_p = Vector4<S>::Zero();
    for (int j = 0; j <= k; ++j) {
      const BodyInMotion<S>& body = past_[first + j][b];
      const S of_x = formula.of_x[j], of_rate = h_ * formula.of_rate[j],
              of_second = h_ * h_ * formula.of_second[j];
      of_r += of_x * (body.r - middle.r) + of_rate * body.v + of_second * body.a;
      if (j == k / 2) {  // p = (1, 0), p' = 0
        of_p[0] += of_x;
        of_p.template tail<3>() += of_second / 2 * body.omega_bar_dot;
        continue;
      }
      const Vector4<S> even =
          exponential_parameters(Vector3<S>((formula.at[k / 2] - formula.at[j]) * h_ * middle.omega_bar));
      Vector4<S> p = multiply_parameters(even, multiply_parameters(back, body.p));
      if (p[0] < S(0)) p = -p;
      // A(p) turns with omega; `evenly` is the even rotation in the frame of the body
      const Vector3<S> e = p.template tail<3>(), turned = 2 * middle.omega_bar.cross(e),
                       evenly = middle.omega_bar + p[0] * turned + turned.cross(e),
                       omega = body.omega_bar - evenly, omega_dot = body.omega_bar_dot + omega.cross(evenly);
      of_p += (of_x - of_second / 4 * omega.squaredNorm()) * p +
              rate_of_parameters(p, Vector3<S>(of_rate * omega + of_second * omega_dot));
    }
    return of_r.norm() + 2 * sums_.reach(b) * of_p.norm();
  }
  /// p' = G^T omega_bar / 2.
  static Vector4<S> rate_of_parameters(const Vector4<S>& p, const Vector3<S>& omega_bar) {
    const Vector3<S> e = p.template tail<3>();
    Vector4<S> rate;
    rate << -e.dot(omega_bar) / 2, (p[0] * omega_bar + e.cross(omega_bar)) / 2;
    return rate;
  }
  S velocity_error(int b, const StepFormula<S>& formula) const {
    Vector3<S> of_v = Vector3<S>::Zero(), of_omega_bar = of_v;
    const int times = formula.times(), first = static_cast<int>(past_.size()) - times;
    for (int j = 0; j < times; ++j) {
      const BodyInMotion<S>& body = past_[first + j][b];
      const S of_x = formula.of_x[j], of_rate = h_ * formula.of_rate[j];
      of_v += of_x * body.v + of_rate * body.a;
      of_omega_bar += of_x * body.omega_bar + of_rate * body.omega_bar_dot;
    }
    return of_v.norm() + sums_.reach(b) * of_omega_bar.norm();
  }

  const StepFormula<S> positions_, velocities_;
  ErrorSums<S> sums_;
  std::vector<std::vector<BodyInMotion<S>>> past_;  ///< the earliest first
  std::vector<S> length_;                           ///< of the step that led to each state [s]
  S h_{0};
  int known_ = 0, left_out_ = 0;  ///< known_: states whose steps have the same length
  long since_ = 0;                ///< states since the motion began
  bool has_estimated_ = false;
};

}  // namespace trivium
