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
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "bodies/rotations/so3.hpp"
#include "simulation/system/error_sums.hpp"

namespace trivium {

/// A formula that polynomials x(t) satisfy at times h t_j,
///
///     sum_j of_x_j x_j + h of_rate_j x'_j + h^2 of_second_j x''_j = 0.
///
/// It is the divided difference of x that takes time j n_j-fold, n_j = 1, 2 or 3, so that x'_j and x''_j have
/// weights only if n_j exceeds 1 and 2. All polynomials of a degree below sum_j n_j - 1 satisfy it. It is
/// scaled such that x with the errors e c_j leaves the remainder e.
template <class S>
struct StepFormula {
  std::vector<S> at;  ///< t_j
  std::vector<S> of_x, of_rate, of_second;

  StepFormula(const std::vector<int>& n, std::vector<S> times, const std::vector<S>& c)
      : at(std::move(times)) {
    S scale(0);
    for (std::size_t j = 0; j < n.size(); ++j) {
      S w(1), L(0), Q(0);  // w(t) = product of (t - l)^-n_l at j, and sums of its logarithmic derivatives
      for (std::size_t l = 0; l < n.size(); ++l) {
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
      scale += c[j] * of_x.back();
    }
    for (auto* of : {&of_x, &of_rate, &of_second})
      for (S& weight : *of) weight /= scale;
  }
  /// Of even steps with equal errors: t_j = c_j = j.
  static StepFormula even(const std::vector<int>& n) {
    std::vector<S> j;
    while (j.size() < n.size()) j.emplace_back(static_cast<double>(j.size()));
    return {n, j, j};
  }
  int times() const { return static_cast<int>(at.size()); }
};

/// Sums the local errors of a method of order 1 to 5. At the steps for which higher orders are made, no
/// formula over past states is more accurate than they are (see simulation/halved_step_errors.hpp). Every
/// fourth step is estimated, or fewer where states are expensive, so that an estimate costs less than a
/// twentieth of the step; and the last steps before the motion ends or begins anew. Where the formula has too
/// few states, or steps differ in length, it is replaced by another one. By a method of an order above 2,
/// single steps between two beginnings are not estimated.
template <class S>
class LocalError {
 public:
  static constexpr int highest_order = 5;

  /// `order` of the method, 1 to 5; `reach` and `component` of each body as for ErrorSums.
  LocalError(int order, std::vector<S> reach, std::vector<int> component)
      : order_(order), even_(even_window()), sums_(std::move(reach), std::move(component)) {
    past_.resize(even_.states.size());
    length_.resize(even_.states.size());
  }

  /// The motion begins at this state, or begins anew with other loads or velocities.
  void begin(std::vector<BodyInMotion<S>>& bodies) {
    end();
    kept_ = left_out_ = wait_ = 0;
    keep(bodies, S(0));
  }
  /// Whether the end of the next step is left out, and need not be given to `add`.
  bool leaves_out() {
    if (left_out_ == 0) return false;
    --left_out_;
    sums_.step();
    return true;
  }
  /// Adds the end of a step of length h [s]. If states are expensive, as many as a formula needs are left out
  /// after each estimate.
  void add(std::vector<BodyInMotion<S>>& bodies, const S& h, bool is_expensive) {
    sums_.step();
    keep(bodies, h);
    if (kept_ < most() || --wait_ > 0) return;
    estimate();
    wait_ = 4;
    if (is_expensive) {
      kept_ = wait_ = 0;
      left_out_ = most();
    }
  }
  /// The sums so far; the motion ends here, or begins anew. `least` as for ErrorSums.
  LocalErrorSums sums(const std::vector<double>& least) {
    end();
    return sums_.sums(least, {least.size(), {1.0, 1.0}});
  }

 private:
  /// The formulas for some of the past states.
  struct Window {
    S h;  ///< the longest step [s]
    std::vector<int> states;
    StepFormula<S> positions, velocities;  ///< that of positions is for the last states
  };
  /// How often the formula for positions takes its states. Its remainder, and that of the formula for
  /// velocities, has at least one power of h more than the errors of the method. Symmetric n_j give all steps
  /// weights of one sign, so that errors of different sizes do not cancel.
  std::vector<int> of_positions() const {
    return order_ <= 2 ? std::vector<int>{3, 3} : std::vector<int>{3, 2, 3};
  }
  Window even_window() const {
    const std::vector<int> n((order_ + 5) / 2, 2);
    std::vector<int> states(n.size());
    std::iota(states.begin(), states.end(), 0);
    return {S(0), std::move(states), StepFormula<S>::even(of_positions()), StepFormula<S>::even(n)};
  }
  /// Of steps of different lengths, whose errors are in proportion to h^(order + 1); or nothing if there are
  /// too few. States are left out that are so near to another that formulas would enlarge their rounding.
  std::optional<Window> uneven_window() const {
    using std::pow;
    constexpr double near = 0.2;  // of the longest step; the fifth power of its inverse is 3000
    const auto begin = length_.end() - kept_ + 1;
    const S h = begin < length_.end() ? *std::max_element(begin, length_.end()) : S(0);
    std::vector<int> states{most() - kept_};
    std::vector<S> t{S(0)}, c{S(0)};
    S now(0), error(0);
    for (int k = states[0] + 1; k < most(); ++k) {
      now += length_[k] / h;
      error += pow(S(length_[k] / h), order_ + 1);
      if (now - t.back() < S(near)) {
        if (k + 1 < most()) continue;
        for (auto* of : {&t, &c}) of->pop_back();
        states.pop_back();
      }
      states.push_back(k);
      t.push_back(now);
      c.push_back(error);
    }
    const long times = even_.positions.times();
    if (static_cast<long>(states.size()) < times) return {};
    for (S& sum : c) sum *= (kept_ - 1) / error;  // the remainder is the mean error
    return Window{h,
                  states,
                  {of_positions(), {t.end() - times, t.end()}, {c.end() - times, c.end()}},
                  {std::vector<int>(t.size(), 2), t, c}};
  }
  /// The number of states that are kept at most.
  int most() const { return static_cast<int>(past_.size()); }

  void keep(std::vector<BodyInMotion<S>>& bodies, const S& h) {
    std::rotate(past_.begin(), past_.begin() + 1, past_.end());
    std::rotate(length_.begin(), length_.begin() + 1, length_.end());
    past_.back().swap(bodies);
    length_.back() = h;
    sums_.see(past_.back());
    kept_ = std::min(kept_ + 1, most());
    is_fresh_ = true;
  }
  /// The motion, or a part of it before it begins anew, has ended.
  void end() {
    // formulas of fewer states are less accurate
    if (is_fresh_ && (kept_ == most() || !sums_.part_is_known())) estimate();
    sums_.end_part();
  }
  void estimate() {
    is_fresh_ = false;
    if (kept_ == most() && is_even()) {
      even_.h = length_.back();
      enter(even_);
    } else if (const auto window = uneven_window()) {
      enter(*window);
    }
  }
  /// A relative change of h by 1e-6 changes an estimate as little, and is far above the rounding of times.
  bool is_even() const {
    using std::abs;
    return std::all_of(length_.begin() + 1, length_.end(),
                       [&](const S& h) { return abs(h - length_.back()) <= S(1e-6) * length_.back(); });
  }
  void enter(const Window& window) {
    sums_.add([&](int b) { return std::pair(position_error(b, window), velocity_error(b, window)); });
  }

  S position_error(int b, const Window& window) const {
    const StepFormula<S>& formula = window.positions;
    const int k = formula.times() - 1;
    const auto* state = &window.states.back() - k;
    const BodyInMotion<S>& middle = past_[state[k / 2]][b];
    const Vector4<S> back = conjugate_parameters(middle.p);
    Vector3<S> of_r = Vector3<S>::Zero();
    Vector4<S> of_p = Vector4<S>::Zero();
    for (int j = 0; j <= k; ++j) {
      const BodyInMotion<S>& body = past_[state[j]][b];
      const S of_x = formula.of_x[j], of_rate = window.h * formula.of_rate[j],
              of_second = window.h * window.h * formula.of_second[j];
      of_r += of_x * (body.r - middle.r) + of_rate * body.v + of_second * body.a;
      if (j == k / 2) {  // p = (1, 0), p' = 0
        of_p[0] += of_x;
        of_p.template tail<3>() += of_second / 2 * body.omega_bar_dot;
        continue;
      }
      const Vector4<S> even = exponential_parameters(
          Vector3<S>((formula.at[k / 2] - formula.at[j]) * window.h * middle.omega_bar));
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
  S velocity_error(int b, const Window& window) const {
    Vector3<S> of_v = Vector3<S>::Zero(), of_omega_bar = of_v;
    for (int j = 0; j < window.velocities.times(); ++j) {
      const BodyInMotion<S>& body = past_[window.states[j]][b];
      const S of_x = window.velocities.of_x[j], of_rate = window.h * window.velocities.of_rate[j];
      of_v += of_x * body.v + of_rate * body.a;
      of_omega_bar += of_x * body.omega_bar + of_rate * body.omega_bar_dot;
    }
    return of_v.norm() + sums_.reach(b) * of_omega_bar.norm();
  }

  int order_;
  Window even_;
  ErrorSums<S> sums_;
  std::vector<std::vector<BodyInMotion<S>>> past_;  ///< the earliest first
  std::vector<S> length_;                           ///< of the step that led to each state [s]
  int kept_ = 0;                 ///< states since the motion began, or states were left out
  int wait_ = 0, left_out_ = 0;  ///< steps up to the next estimate, or the next state
  bool is_fresh_ = false;        ///< whether the last state has entered no estimate
};

}  // namespace trivium
