#pragma once
/// Half-explicit Runge-Kutta methods for index 2. The stages are explicit in q and v; the multipliers of a
/// stage are those that make the velocities of the next stage meet their rows:
///
///   Q_i = q_n + h sum_{j<i} a_ij Q'_j,   V_i = v_n + h sum_{j<i} a_ij V'_j
///
///   M(Q_i) V'_i + Phi_q(Q_i)^T lambda_i = Q(Q_i, V_i, t_i),   Phi_q(Q_i+1) V_i+1 = nu(t_i+1)
///
/// HEM4 has order 4 (Brasey and Hairer, SIAM Journal on Numerical Analysis 30, 1993). HEDOP5 is the formula
/// 5(4) of Dormand and Prince in this form (Arnold and Murua, Numerical Algorithms 19, 1998). Its seventh
/// stage lies at the end of the step. The multipliers of this stage make the velocities of an extra state, at
/// 19/20 of the step, meet their rows. The first stage of the next step takes over V' and the rate of the
/// work of this stage.
///
/// A stage has the forces of its own state but the rows of the next stage, so that its linear system is not
/// symmetric. `solve` iterates with the symmetric matrix of the stage instead; an iteration reduces the error
/// by a factor of about the angle by which bodies rotate between the two stages. `solve` also decides when
/// the rows count as met and when the iteration diverges.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "integrators/contract/internal_rows.hpp"
#include "integrators/contract/newton_matrix.hpp"
#include "integrators/explicit/half_explicit_coefficients.hpp"
#include "integrators/step_size_control.hpp"

namespace trivium::integrators {

/// `Coefficients` are those of HEM4 or HEDOP5 (half_explicit_coefficients.hpp).
template <HasNewtonMatrix System, class Coefficients>
requires HasInternalRows<System>
class HalfExplicit {
 public:
  using S = typename System::Scalar;

  /// With tolerances the method chooses its steps, which needs an embedded formula; without them it takes the
  /// given steps, or those of ErrorControl (error_control.hpp).
  explicit HalfExplicit(std::optional<Tolerances> tolerances = {}) : tolerances_(tolerances) {}

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    if (!has_begun_) begin(system, t, y, stop);
    if (!tolerances_) {
      advance(system, t, stop - t, y);
      require_finite(reached_, stop);
      accept(system, stop - t, y);
      t = stop;
      return;
    }
    // the embedded formula has order 4, hence the power -1/5; growth by at most 5, about as in Odeint
    take_chosen_step(
        step_size_, {S(-0.2), S(5)}, counters_, t, stop,
        [&](const S& h) {
          advance(system, t, h, y);
          return error_of(h, y);
        },
        [&](const S& h) { accept(system, h, y); });
  }
  /// Computes a step from (t, y) to `stop`, whose end is `reached`; nothing is remembered before `accept`.
  void attempt(System& system, const S& t, const S& stop, const StateVector<S>& y, StateVector<S>& reached) {
    advance(system, t, stop - t, y);
    reached = reached_;
  }
  /// Accepts the step of length h that was computed last; `y` is set to its end.
  void accept(System&, const S& h, StateVector<S>& y) {
    const S work = y.size() > nq_ + nv_ ? y[nq_ + nv_] : S(0);
    y = reached_;
    if (y.size() > nq_ + nv_) {
      y[nq_ + nv_] = work;
      for (int j = 0; j < end; ++j) y[nq_ + nv_] += h * of_.a[end][j] * stage_[j].work_rate;
    }
    if constexpr (first_is_known) {
      std::swap(stage_[0].v_dot, stage_[stages - 1].v_dot);
      stage_[0].work_rate = stage_[stages - 1].work_rate;
    }
    last_lambda_ = lambda_;
    has_stepped_ = true;
    ++counters_.steps;
  }
  void restart() {
    has_begun_ = has_stepped_ = false;
    step_size_.restart();
    ++counters_.restarts;
  }
  bool shorten() {
    if (!tolerances_) return false;
    has_begun_ = has_stepped_ = false;
    step_size_.shorten();
    --counters_.steps;
    ++counters_.rejected_steps;
    return true;
  }
  const Counters& counters() const { return counters_; }
  /// The multipliers of the last stage, which lies at the end of the step.
  const StateVector<S>* lambda() const { return has_stepped_ ? &last_lambda_ : nullptr; }

  bool has_begun() const { return has_begun_; }
  void begin(System& system, const S& t, const StateVector<S>& y, const S& /*stop*/) {
    nq_ = system.position_size();
    nv_ = system.velocity_size();
    if constexpr (first_is_known) {
      StateVector<S> y_dot;
      system.derivative(t, y, y_dot);
      system.accelerations(t, y, stage_[0].v_dot, lambda_);
      if (y.size() > nq_ + nv_) stage_[0].work_rate = y_dot[nq_ + nv_];
      counters_.right_sides += 2;
    }
    if (tolerances_ && !step_size_.has_begun())
      step_size_.begin(first_step(system, t, y, 5, *tolerances_, counters_.right_sides));
    has_begun_ = true;
  }

  void show_memory(auto&& show) {
    if constexpr (first_is_known) show(stage_[0].v_dot, stage_[0].work_rate);
  }

 private:
  static constexpr int stages = Coefficients::stages, end = Coefficients::end;
  static constexpr bool first_is_known = Coefficients::first_is_known;

  struct Stage {
    StateVector<S> q_dot, v_dot;
    S work_rate{0};
  };

  /// Computes the stages of a step and the state `reached_` at its end; y does not change.
  void advance(System& system, const S& t, const S& h, const StateVector<S>& y) {
    lambda_.setZero(system.multipliers());
    at_ = y;
    for (int i = 0; i < stages; ++i) {
      Stage& stage = stage_[i];
      next_ = y;
      v_ = at_.segment(nq_, nv_);
      system.position_rate(at_, v_, stage.q_dot);
      for (int j = 0; j <= i; ++j) {
        next_.head(nq_) += h * of_.a[i + 1][j] * stage_[j].q_dot;
        if (j < i) next_.segment(nq_, nv_) += h * of_.a[i + 1][j] * stage_[j].v_dot;
      }
      if (first_is_known && i == 0) {
        next_.segment(nq_, nv_) += h * of_.a[1][0] * stage.v_dot;
      } else {
        solve(system, t + of_.c[i] * h, t + of_.c[i + 1] * h, h * of_.a[i + 1][i], at_, stage.v_dot);
        if (y.size() > nq_ + nv_) stage.work_rate = system.work_rate(stage_at_, lambda_);
      }
      std::swap(at_, next_);
      if (i + 1 == end) reached_ = at_;
    }
  }
  /// The estimated error of a step [tolerances]; 0 without an embedded formula.
  S error_of(const S& h, const StateVector<S>& y) {
    if constexpr (requires { of_.embedded; }) {
      off_.setZero(nq_ + nv_);
      for (int j = 0; j < stages; ++j) {
        const S share = h * (of_.a[end][j] - of_.embedded[j]);
        off_.head(nq_) += share * stage_[j].q_dot;
        off_.tail(nv_) += share * stage_[j].v_dot;
      }
      using std::sqrt;
      const auto allowed =
          (S(tolerances_->atol) + S(tolerances_->rtol) * y.cwiseAbs().cwiseMax(reached_.cwiseAbs()).array())
              .head(nq_ + nv_);
      return sqrt(S((off_.array() / allowed).square().sum() / S(nq_ + nv_)));
    } else {
      return S(0);
    }
  }

  /// Solves for V' and lambda of the stage at (t, y) so that the velocities of the next stage meet their rows
  /// at t_next. These velocities, in next_, change by `share` times V'.
  void solve(System& system, const S& t, const S& t_next, const S& share, const StateVector<S>& y,
             StateVector<S>& v_dot) {
    v_dot.setZero(nv_);
    lambda_.setZero();
    system.evaluate(t, y, stage_at_);
    system.residual(stage_at_, v_dot, lambda_, left_);
    ++counters_.right_sides;
    system.internal_residual(stage_at_, v_dot, left_);
    system.factor(stage_at_, {}, factors_);
    system.solve_internal_rows(stage_at_, left_, v_dot);
    next_.segment(nq_, nv_) += share * v_dot;
    S before = std::numeric_limits<S>::max();
    Violation<S> missed;
    // Safety limit: at an angle of 0.5 rad between two stages, about 50 repetitions reach rounding in double.
    // Where the error no longer falls, up to 1000 times the bound of rounding is accepted, a safety factor.
    constexpr int most_repetitions = 60;
    for (int k = 0; k < most_repetitions; ++k) {
      system.evaluate(t_next, next_, next_at_);
      missed = system.velocity_rows(next_at_, rows_);
      const S& violation = missed.relative;
      if (k > 0 && violation <= rounding<S>()) return;
      if (!(violation < before)) {
        if (k > 1 && violation <= 1000 * rounding<S>()) return;
        if (k > 1) break;
      }
      before = violation;
      change_.setZero(nv_);
      rows_ /= -share;
      system.solve(factors_, stage_at_, left_, rows_, change_, lambda_);
      left_.setZero();
      v_dot += change_;
      next_.segment(nq_, nv_) += share * change_;
      ++counters_.iterations;
    }
    throw IntegrationError({fmt::format("row \"{}\"", system.row_name(missed.row)), static_cast<double>(t)},
                           "the iteration for the multipliers of a stage does not converge for this row; "
                           "take smaller steps, or another method if constraints are redundant");
  }

  const Coefficients of_;
  const std::optional<Tolerances> tolerances_;
  StepSizeControl<S> step_size_;
  std::array<Stage, stages> stage_;
  typename System::Evaluation stage_at_, next_at_;  ///< the model at this stage and at the next
  typename System::Factors factors_;
  StateVector<S> at_, next_, reached_, lambda_, last_lambda_, left_, rows_, change_, v_, off_;
  int nq_ = 0, nv_ = 0;
  bool has_begun_ = false, has_stepped_ = false;
  Counters counters_;
};

}  // namespace trivium::integrators
