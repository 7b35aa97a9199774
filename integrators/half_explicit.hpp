#pragma once
/// HEM4, half-explicit of order 4 on index 2 (Brasey and Hairer 1993): stages are explicit in q and v, and
/// each one's multipliers are what puts the velocities of the next onto their rows:
///
///   Q_i = q_n + h sum_{j<i} a_ij Q'_j,   V_i = v_n + h sum_{j<i} a_ij V'_j
///
///   M(Q_i) V'_i + Phi_q(Q_i)^T lambda_i = Q(Q_i, V_i, t_i),   Phi_q(Q_i+1) V_i+1 = nu(t_i+1)
///
/// The rows are those of the next stage and the forces those of this one; the symmetric matrix of this stage
/// solves for both by repetition, which falls by about the angle that bodies turn between the two.

#include <array>
#include <cmath>
#include <limits>

#include "integrators/step_choice.hpp"

namespace trivium::integrators {

/// Its coefficients: the last row is that of the step.
template <class S>
struct HalfExplicitCoefficients {
  std::array<S, 6> c;
  std::array<std::array<S, 5>, 6> a;

  HalfExplicitCoefficients() {
    using std::sqrt;
    const S r = sqrt(S(6)), o(0);
    c = {o, S(3) / 10, (4 - r) / 10, (4 + r) / 10, S(1), S(1)};
    a = {{{o, o, o, o, o},
          {S(3) / 10, o, o, o, o},
          {(1 + r) / 30, (11 - 4 * r) / 30, o, o, o},
          {(-79 - 31 * r) / 150, (-1 - 4 * r) / 30, (24 + 11 * r) / 25, o, o},
          {(14 + 5 * r) / 6, (-8 + 7 * r) / 6, (-9 - 7 * r) / 4, (9 - r) / 4, o},
          {o, o, (16 - r) / 36, (16 + r) / 36, S(1) / 9}}};
  }
};

template <ConstrainedSystem System>
class HalfExplicit {
 public:
  using S = typename System::Scalar;

  void step(System& system, S& t, Flat<S>& y, const S& stop) {
    const S h = stop - t;
    const int nq = system.position_size(), nv = system.velocity_size();
    lambda_.setZero(system.multipliers());
    const Flat<S> y_n = y;
    S work(0);
    for (int i = 0; i < stages; ++i) {
      // y is stage i
      next_ = y_n;
      system.position_rate(y, y.segment(nq, nv), rate_[i].position);
      for (int j = 0; j <= i; ++j) {
        next_.head(nq) += h * of_.a[i + 1][j] * rate_[j].position;
        if (j < i) next_.segment(nq, nv) += h * of_.a[i + 1][j] * rate_[j].velocity;
      }
      advance(system, t + of_.c[i] * h, t + of_.c[i + 1] * h, h * of_.a[i + 1][i], y, rate_[i].velocity);
      if (y.size() > nq + nv) work += h * of_.a[stages][i] * S(system.work_rate(lambda_));
      y = next_;
    }
    require_finite(y, stop);
    if (y.size() > nq + nv) y[nq + nv] = y_n[nq + nv] + work;
    t = stop;
    ++counters_.steps;
  }
  void restart() { ++counters_.restarts; }
  bool shorten() { return false; }
  const Counters& counters() const { return counters_; }
  /// Of the last stage, at the step's end.
  const Flat<S>* lambda() const { return counters_.steps > 0 ? &lambda_ : nullptr; }

 private:
  static constexpr int stages = 5;

  /// V' and lambda of the stage at y, that lead the next one's velocities, which move with V' by `share`,
  /// onto their rows.
  void advance(System& system, const S& t, const S& t_next, const S& share, const Flat<S>& y,
               Flat<S>& v_dot) {
    const int nq = system.position_size(), nv = system.velocity_size();
    v_dot.setZero(nv);
    lambda_.setZero();
    system.balance(t, y, v_dot, lambda_);
    ++counters_.right_sides;
    system.take_imbalance(left_);
    system.take_internal_rows(v_dot, left_);
    system.factor(S(0), S(0));
    system.solve_internal_rows(y, left_, v_dot);
    next_.segment(nq, nv) += share * v_dot;
    S before = std::numeric_limits<S>::max();
    constexpr int most_repetitions = 60;
    for (int k = 0; k < most_repetitions; ++k) {
      system.position_rows(t_next, next_);
      const S violation = system.velocity_rows();
      system.take_rows(rows_);
      system.position_rows(t, y);  // the changes are those of this stage
      if (k > 0 && violation <= rounding<S>()) return;
      if (!(violation < before)) {
        if (k > 1 && violation <= 1000 * rounding<S>()) return;
        if (k > 1) break;
      }
      before = violation;
      change_.setZero(nv);
      system.solve(left_, rows_ / -share, change_, lambda_);
      left_.setZero();
      v_dot += change_;
      next_.segment(nq, nv) += share * change_;
      ++counters_.iterations;
    }
    system.position_rows(t_next, next_);
    system.velocity_rows();  // for its name
    throw IntegrationError(fmt::format(
        "at t = {}: velocities of the next stage do not come to meet row \"{}\"; take smaller steps",
        static_cast<double>(t), system.least_met_row()));
  }

  struct Rate {
    Flat<S> position, velocity;
  };

  const HalfExplicitCoefficients<S> of_;
  std::array<Rate, stages> rate_;
  Flat<S> next_, lambda_, left_, rows_, change_;
  Counters counters_;
};

}  // namespace trivium::integrators
