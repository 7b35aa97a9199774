#pragma once
/// Radau IIA with s stages, of order 2 s - 1, for the stabilised index-2 equations of Gear, Gupta and
/// Leimkuhler. Sources: Hairer and Wanner, Solving Ordinary Differential Equations II (1996), IV.8 and VII;
/// for more than three stages: Hairer and Wanner, Stiff differential equations solved by Radau methods, J.
/// Comput. Appl. Math. 111 (1999). Stage i = 1 .. s has the unknowns v'_i, lambda_i and a shift sigma_i; the
/// last stage lies at the end of the step:
///
///   v_i = v_n + h sum a_ij v'_j,   M(q_i) v'_i + Phi_q^T lambda_i = Q(q_i, v_i, t_i),   Phi_q v_i = nu
///
///   q_i = q_n o exp(theta_i),   theta_i = h sum a_ij T(theta_j)^-1 (v_j + sigma_j)
///
///   Phi(q_i, t_i) = 0,   M sigma_i + Phi_q^T mu_i = 0
///
/// q_n, v_n: the state at the start of the step. q o exp(theta): the positions q, displaced by theta. Q: the
/// generalised force. A = (a_ij): the coefficient matrix of the method, not a rotation. The last equation
/// makes sigma_i the smallest motion that satisfies the position rows; mu_i are its multipliers. The equation
/// takes M and Phi_q from the factored Newton matrix, where M includes the resistance of the springs. The
/// method's raw lambda has order s. The parts of the method:
///
///   radau_coefficients.hpp   c, A and the weights of the error estimate
///   radau_stages.hpp         the stages: q_i and v_i from the unknowns, internal rows
///   radau_springs.hpp        coupling of the stages by springs and dampers
///   radau_error.hpp          norms of corrections and of the error estimate
///   row_projection.hpp       projection of the step's end onto the constraints
///
/// This file has the iteration, a simplified Newton iteration. Each stage has its own real matrix, factored
/// at the state of that stage, because stiff springs may rotate within one step. The right sides of the rows
/// are multiplied by A^-1, which decouples the rows of the stages. The coupling by springs is solved for in
/// radau_springs.hpp. Anderson acceleration makes up for the terms that the matrices leave out.
/// `solve_stages` decides when the iteration has converged, when matrices are factored again, and when the
/// iteration diverges. With tolerances it has converged when the observed convergence rate says that the
/// changes still to come are small. `advance` tries simpler predictions after a divergence. If none of them
/// converges, take_chosen_step tries a quarter of the step size; with given steps the run ends.

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

/// The number of stages s is odd: only then does A have a real eigenvalue, with which the matrices of the
/// stages are real.
template <HasSprings System, int s>
requires HasInternalRows<System>
class Radau {
 public:
  using S = typename System::Scalar;

  /// With tolerances the method chooses its steps; without them it takes the given steps.
  Radau(std::optional<Tolerances> tolerances, const NewtonOptions& newton)
      : newton_(newton), stages_(placed_within(tolerances)) {
    // With order 9 the error of a step soon falls below the effect of an imbalance of 1e-10, the default
    // tolerance. 0 demands an imbalance of rounding size; `solve_stages` accepts a larger one if the
    // iteration can no longer reduce it. With tolerances the size of the corrections ends the iteration, at
    // any imbalance: the imbalance of forces does not tell how large the errors of positions are.
    if (tolerances || s > 3) newton_.tolerance = 0;
    if (!tolerances) return;
    error_.emplace(*tolerances);
    // The factor 10 is chosen by experiment: a larger one accepts less accurate stages, a smaller one takes
    // rounding for divergence.
    rounding_level_ = std::min(rounding_level_, 10 * tolerances->rtol);
    // For rtol >= 1e-3 the value is 0.03, as in the code RADAU5 of Hairer and Wanner. The error estimate has
    // order s: with s = 3 the number of steps grows with rtol^-1/4, and the factor rtol^1/4 keeps the sum of
    // the iteration errors of all steps, in units of the tolerance, about the same. With s = 5 it grows with
    // rtol^-1/6 only, and the factor is stricter than necessary.
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
    // a step may be up to 8 times as long as the one before, as in RADAU5
    take_chosen_step(
        step_size_, {S(-1) / (s + 1), S(8)}, counters_, t, stop,
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
    // The start evaluates the model up to h / 8 ahead. With tolerances stop - t is no step size, and a state
    // so far ahead may not exist. Only v' and lambda are used here, which do not depend on h. The time ahead
    // may therefore be any small one; h / 1000 is arbitrary.
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

  /// Relative tolerance [-] of the displacements theta_i. It is relative to the displacement, not to the
  /// position, so that the errors of many short steps add up to no more than those of a few long steps. The
  /// factor 1e-3 is a safety factor below rtol.
  static S placed_within(const std::optional<Tolerances>& tolerances) {
    return std::max(2 * std::numeric_limits<S>::epsilon(), tolerances ? S(1e-3 * tolerances->rtol) : S(0));
  }

  /// Solves the stages of a step from y, which does not change. Returns the estimated error [tolerances], 0
  /// for given steps.
  S advance(System& system, const S& t, const S& h, const StateVector<S>& y) {
    const auto solved = [&] { return solve_stages(system, t, h, y); };
    const auto solved_from = [&](const StateVector<S>& v_dot) {
      stages_.begin_with(v_dot, stages_.known().lambda);
      return solved();
    };
    // The predictions are tried in this order: the polynomial through the last step's stages, the last v' for
    // all stages, v' = 0. After a transient the first may be far off, and within a transient even the second.
    if (!(stages_.predict(h) && solved()) && !solved_from(stages_.known().v_dot) &&
        !solved_from(StateVector<S>::Zero(nv_)))
      throw_not_converged(system, t, violation_);
    if (!error_) return S(0);
    // the error estimate needs factors, and none exist if the predicted stages met their equations at once
    if (!has_matrix_) factor(system, h);
    return error_->of_step(system, stages_, h, y);
  }

  /// Iterates from the predicted stages. Returns whether the stages solve their equations.
  bool solve_stages(System& system, const S& t, const S& h, const StateVector<S>& y) {
    v_ = y.segment(nq_, nv_);
    anderson_.clear();
    for (int i = 0; i < s; ++i) system.clear_dependent(stages_[i].lambda);
    S before = std::numeric_limits<S>::max(), moved_before = before, moved_earlier = before;
    // 1000: a safety factor, as rounding may leave more than rounding<S>()
    const S enough = std::max(S(newton_.tolerance), rounding<S>()),
            rounding_level = std::max(S(rounding_level_), S(1000 * rounding<S>()));
    // Matrices are factored in the first iteration. As soon as residuals or changes fail to halve, they are
    // factored in every iteration.
    bool is_fresh = false, at_each = newton_.is_full;
    const auto refresh = [&] {
      if (!std::exchange(at_each, true)) anderson_.clear();
    };
    // 40 iterations, 5 without progress: the limits of newton.hpp
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
        // The residual no longer halves. If it is small, rounding is the cause, and the stages are solved.
        // The imbalance is relative to the largest forces and hides the forces on much lighter bodies. The
        // last change shows these too, so that it must be within the tolerances.
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
      // the convergence rate: over the last change and over the last two, as a single change may be small by
      // chance
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

  /// Solves for corrections of the unknowns of every stage (v', lambda, shift) and of `stretched`, the
  /// stretch of the springs by the shift. Adds the accelerated correction to the stages and returns it.
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
          // Right side -M sigma: the solution removes the part of the shift that is tangential to the
          // constraints. The slack -stretched makes the springs resist the whole shift, not only the
          // correction that is solved for.
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
  std::optional<RadauError<System, s>> error_;  ///< absent for given steps
  /// Relative imbalance [-] up to which a residual that no longer halves counts as rounding: 1000 times the
  /// default tolerance of NewtonOptions.
  double rounding_level_ = 1e-7;
  S iteration_tolerance_{0};  ///< bound of the changes still to come [tolerances]; smaller for smaller rtol
  StepSizeControl<S> step_size_;
  Anderson<S> anderson_;
  Stages stages_;
  RadauSprings<System, s> springs_;
  RowProjection<System> row_projection_;
  Violation<S> violation_;  ///< at the last iterate
  std::array<S, s> stage_work_;
  StateVector<S> v_, force_, along_, change_;
  int nq_ = 0, nv_ = 0, nc_ = 0;
  bool has_begun_ = false, has_matrix_ = false;
  Counters counters_;
};

/// Radau IIA of order 5.
template <class System>
using Radau5 = Radau<System, 3>;
/// Radau IIA of order 9.
template <class System>
using Radau9 = Radau<System, 5>;

}  // namespace trivium::integrators
