#pragma once
/// Radau IIA of s stages, of order 2 s - 1, on the stabilised index 2 (Gear, Gupta and Leimkuhler): Hairer
/// and Wanner, Solving Ordinary Differential Equations II (1996), IV.8 and VII; of more than three stages:
/// Hairer and Wanner, Stiff differential equations solved by Radau methods, J. Comput. Appl. Math. 111
/// (1999). Stages i = 1 .. s, the last at the end of the step:
///
///   V_i = v_n + h sum a_ij V'_j,   M(Q_i) V'_i + Phi_q^T lambda_i = Q(Q_i, V_i, t_i),   Phi_q V_i = nu
///
///   Q_i = q_n o exp(theta_i),   theta_i = h sum a_ij T(theta_j)^-1 (V_j + s_j)
///
///   Phi(Q_i, t_i) = 0,   M s_i + Phi_q^T mu_i = 0
///
/// with M and Phi_q of the last from Newton's matrix, the springs' resistance included. Order s in its own
/// lambda. Its parts:
///
///   radau_coefficients.hpp   c, A and the error's weights
///   radau_stages.hpp         where the unknowns of the stages lead
///   radau_springs.hpp        what springs do from stage to stage
///   radau_error.hpp          corrections and the estimated error, in tolerances
///   row_projection.hpp       the end of a step moved onto its rows
///
/// Here is the iteration. Newton's matrix is real for each stage, and made where that stage is, as stiff
/// springs turn within a step. Rows are met through A^-1. `solve_stages` decides when the iteration has
/// converged (to tolerances: where the changes still to come are small by those that came), when a new matrix
/// is made, and that the iteration diverges. `advance` then begins it from simpler predictions; where none
/// leads to a solution, take_chosen_step tries a quarter of the length, and a given step ends the run.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "integrators/implicit/newton.hpp"
#include "integrators/implicit/radau_error.hpp"
#include "integrators/implicit/radau_springs.hpp"
#include "integrators/implicit/radau_stages.hpp"
#include "integrators/implicit/row_projection.hpp"
#include "integrators/initial_acceleration.hpp"
#include "integrators/step_size_control.hpp"

namespace trivium::integrators {

/// Of an odd number of stages.
template <HasSprings System, int s>
requires HasInternalRows<System>
class Radau {
 public:
  using S = typename System::Scalar;

  /// Steps of its own choice to the tolerances, or of the grid's length.
  Radau(std::optional<Tolerances> tolerances, const NewtonOptions& newton)
      : newton_(newton), stages_(placed_within(tolerances)) {
    // errors of order 9 are soon below what a balance to 1e-10 leaves
    if (tolerances || s > 3) newton_.tolerance = 0;
    if (!tolerances) return;
    error_.emplace(*tolerances);
    // changes say when to end, beside the errors that tolerances are about; forces would not
    rounding_level_ = std::min(rounding_level_, 10 * tolerances->rtol);
    iteration_tolerance_ = 0.03 * std::min(1.0, std::pow(tolerances->rtol / 1e-3, 0.25));
  }

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    if (!has_begun_) begin(system, t, y, stop);
    if (!error_) {
      advance(system, t, stop - t, y);
      accept(stop - t, y);
      t = stop;
      return;
    }
    error_->begin(system, t, y);
    take_chosen_step(
        system, step_size_, {S(-1) / (s + 1), S(8)}, counters_, t, y, stop,
        [&](const S& h) {
          const S error = advance(system, t, h, y);
          if (error <= S(1)) row_projection_.move(system, stages_.last().factors, S(t + h), stages_.last().y);
          return error;
        },
        [&](const S& h) { accept(h, y); });
  }
  void restart() {
    has_begun_ = false;
    step_size_.restart();
    ++counters_.restarts;
  }
  bool shorten() {
    if (!error_) return false;
    has_begun_ = false;
    step_size_.shorten();
    --counters_.steps;
    ++counters_.rejected_steps;
    return true;
  }
  const Counters& counters() const { return counters_; }
  const StateVector<S>* lambda() const { return has_begun_ ? &stages_.last().lambda : nullptr; }

  bool has_begun() const { return has_begun_; }
  void begin(System& system, const S& t, const StateVector<S>& y, const S& stop) {
    nq_ = system.position_size();
    nv_ = system.velocity_size();
    nc_ = system.multipliers();
    springs_.begin(system);
    const S h = stop - t;
    const InitialAcceleration<S> start(system, t, y, error_ ? h / 1000 : h, counters_);
    stages_.begin(system, springs_.size(), start.v_dot, start.lambda);
    has_matrix_ = false;
    if (error_ && !step_size_.has_begun())
      step_size_.begin(first_step(system, t, y, s, error_->tolerances(), counters_.right_sides));
    has_begun_ = true;
  }
  void show_memory(auto&& show) { stages_.show_memory(show); }

 private:
  using Stages = RadauStages<System, s>;
  using Stage = typename Stages::Stage;

  /// Of displacements, beside their own size: many short steps then miss no more than a few long ones.
  static S placed_within(const std::optional<Tolerances>& tolerances) {
    return std::max(2 * std::numeric_limits<S>::epsilon(), tolerances ? S(1e-3 * tolerances->rtol) : S(0));
  }

  /// Solves the stages of a step; y stays. Returns the estimated error, in tolerances.
  S advance(System& system, const S& t, const S& h, const StateVector<S>& y) {
    const auto solved = [&] { return solve_stages(system, t, h, y); };
    const auto solved_from = [&](const StateVector<S>& v_dot) {
      stages_.begin_with(v_dot, stages_.known().lambda);
      return solved();
    };
    // after a transient what the last stages foretell may be far off, and in one even what they end with
    if (!(stages_.predict(h) && solved()) && !solved_from(stages_.known().v_dot) &&
        !solved_from(StateVector<S>::Zero(nv_)))
      throw_not_converged(system, t, violation_);
    if (!error_) return S(0);
    // where the stages were as predicted, none was asked for
    if (!has_matrix_) factor(system, h);
    return error_->of_step(system, stages_, h, y);
  }

  /// From the stages as predicted; whether they came to solve their equations.
  bool solve_stages(System& system, const S& t, const S& h, const StateVector<S>& y) {
    v_ = y.segment(nq_, nv_);
    anderson_.clear();
    S before = std::numeric_limits<S>::max(), moved_before = before, moved_earlier = before;
    const S enough = std::max(S(newton_.tolerance), rounding<S>()),
            rounding_level = std::max(S(rounding_level_), S(1000 * rounding<S>()));
    // the matrix is made for the first iteration and, from where changes do not halve, for every one
    bool is_fresh = false, at_each = newton_.is_full;
    const auto refresh = [&] {
      if (!std::exchange(at_each, true)) anderson_.clear();
    };
    for (int k = 0, rises = 0; k < 40 && rises < 5; ++k) {
      stages_.place(system, h, y, v_);
      stages_.normalise(system, h, y, v_);
      S imbalance(0);
      violation_ = {};
      for (int i = 0; i < s; ++i) {
        Stage& stage = stages_[i];
        if (!stage.v_dot.allFinite() || !stage.lambda.allFinite()) return false;
        system.evaluate(t + stages_.coefficients().c[i] * h, stage.y, stage.at);
        system.inertia_force(stage.at, stage.v_dot, force_);
        raise(imbalance, S(system.residual(stage.at, force_, stage.lambda, stage.left)));
        ++counters_.right_sides;
        raise(violation_, Violation<S>(system.position_rows(stage.at, stage.phi)));
        raise(violation_, Violation<S>(system.velocity_rows(stage.at, stage.phi_dot)));
        stage_work_[i] = y.size() > nq_ + nv_ ? S(system.work_rate(stage.at, stage.lambda)) : S(0);
      }
      const S now = imbalance / enough + violation_.relative / rounding<S>();
      if (imbalance <= enough && violation_.relative <= rounding<S>()) return true;
      const bool falls = now <= before / 2;
      if (!falls) {
        // forces of bodies far lighter than others are none beside theirs, but changes tell of them too
        const bool is_still = !error_ || moved_before <= S(1);
        if (is_fresh && is_still && imbalance <= rounding_level &&
            violation_.relative <= 1000 * rounding<S>())
          return true;
        ++rises;
        refresh();
      }
      before = now;
      is_fresh = k == 0 || at_each;
      const StateVector<S>& step = correct(system, h, is_fresh);
      ++counters_.iterations;
      if (!error_) continue;
      const S moved = error_->of_correction(stages_, step, h, y);
      // how changes fell, of the last one and of the last two: one alone may be small by chance
      using std::sqrt;
      const S share =
          k == 0 ? S(1) : std::max(S(moved / moved_before), k == 1 ? S(0) : S(sqrt(moved / moved_earlier)));
      if (k > 0 &&
          (moved == S(0) || (moved <= S(1) && moved * share <= iteration_tolerance_ * (1 - share)))) {
        stages_.place(system, h, y, v_);
        stages_.normalise(system, h, y, v_);
        return true;
      }
      if (moved > moved_before / 2) refresh();
      moved_earlier = moved_before;
      moved_before = moved;
    }
    return false;
  }

  /// A change of the unknowns by Newton's matrix, and of how far the shift stretches springs; added to them.
  const StateVector<S>& correct(System& system, const S& h, bool makes_matrix) {
    if (makes_matrix) factor(system, h);
    const auto& inverse = stages_.coefficients().inverse;
    const Eigen::Index springs = springs_.size(), behind = s * (2 * nv_ + nc_);
    change_.setZero(behind + s * springs);
    for (int i = 0; i < s; ++i) {
      stages_[i].slack = -stages_[i].stretched;
      stages_[i].rows = stages_[i].phi_dot + stages_.mixed(inverse[i], &Stage::phi) / -h;
    }
    stages_.solve_each(
        system,
        [&](int i) -> const StateVector<S>& {
          // what of the shift is along the rows goes, springs too being in the way
          system.inertia_force(stages_[i].factors, stages_[i].shift, force_);
          force_ = -force_;
          system.reduce(stages_[i].factors, force_, along_);
          return along_;
        },
        [&](int i, const StateVector<S>& x, const StateVector<S>&) {
          change_.segment(s * (nv_ + nc_) + i * nv_, nv_) = x;
          change_.segment(behind + i * springs, springs) = stages_[i].stretch;
          stages_[i].slack.setZero();
        });
    springs_.solve_together(system, h, stages_, change_);
    const StateVector<S>& step = anderson_.step(change_, s * nv_);
    for (int i = 0; i < s; ++i) {
      stages_[i].v_dot += step.segment(i * nv_, nv_);
      stages_[i].lambda += step.segment(s * nv_ + i * nc_, nc_);
      stages_[i].shift += step.segment(s * (nv_ + nc_) + i * nv_, nv_);
      stages_[i].stretched += step.segment(behind + i * springs, springs);
    }
    return step;
  }
  void factor(System& system, const S& h) {
    const S share = h * stages_.coefficients().gamma;
    for (Stage& stage : stages_) system.factor(stage.at, {share * share, share}, stage.factors);
    springs_.refactor(share);
    has_matrix_ = true;
  }

  void accept(const S& h, StateVector<S>& y) {
    const S work = y.size() > nq_ + nv_ ? y[nq_ + nv_] : S(0);
    y = stages_.last().y;
    if (y.size() > nq_ + nv_)
      y[nq_ + nv_] =
          work + h * Stages::mix(stages_.coefficients().a.back(), [&](int j) { return stage_work_[j]; });
    stages_.accept(h);
    ++counters_.steps;
  }

  NewtonOptions newton_;
  std::optional<RadauError<System, s>> error_;  ///< where steps are chosen to tolerances
  double rounding_level_ = 1e-7;                ///< imbalance that rounding may leave
  S iteration_tolerance_{0};                    ///< of changes still to come; less where there are more steps
  StepSizeControl<S> step_size_;
  Anderson<S> anderson_;
  Stages stages_;
  RadauSprings<System, s> springs_;
  RowProjection<System> row_projection_;
  Violation<S> violation_;  ///< of the last iterate
  std::array<S, s> stage_work_;
  StateVector<S> v_, force_, along_, change_;
  int nq_ = 0, nv_ = 0, nc_ = 0;
  bool has_begun_ = false, has_matrix_ = false;
  Counters counters_;
};

template <class System>
using Radau5 = Radau<System, 3>;
template <class System>
using Radau9 = Radau<System, 5>;

}  // namespace trivium::integrators
