#pragma once
/// The stages of one step of Radau IIA: their first guess, their states q_i and v_i, and their internal rows.
/// From the unknowns v'_i, lambda_i and the shift sigma_i of each stage,
///
///   v_i = v_n + h sum a_ij v'_j,   q_i = q_n o exp(theta_i)
///
///   theta_i = h sum a_ij T(theta_j)^-1 (v_j + sigma_j)
///
/// where T(theta)^-1 is displacement_rate of the system: it maps a motion of the bodies to the rate of theta.
/// The symbols are those of radau.hpp; A = (a_ij) is the coefficient matrix of the method.

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "base/raise.hpp"
#include "integrators/contract/internal_rows.hpp"
#include "integrators/contract/springs.hpp"
#include "integrators/implicit/radau_coefficients.hpp"

namespace trivium::integrators {

/// The s stages of a step, and v' and lambda of the previous step's stages for the prediction.
template <HasSprings System, int s>
requires HasInternalRows<System>
class RadauStages {
 public:
  using S = typename System::Scalar;

  /// The part of a stage that the next step's prediction uses.
  struct Known {
    StateVector<S> v_dot, lambda;
  };
  /// One stage: its unknowns, state, residuals and factors.
  struct Stage : Known {
    StateVector<S> shift;                ///< sigma_i: extra motion that the position rows need
    StateVector<S> internal_correction;  ///< extra motion that the internal rows need
    StateVector<S> v, theta, rate, y;    ///< v_i, theta_i, the rate of theta_i, (q_i, v_i)
    StateVector<S> chart_correction;     ///< rate - (v + shift + internal_correction)
    StateVector<S> left, phi, phi_dot;   ///< residuals: of the forces, Phi, Phi_q v_i - nu
    typename System::Evaluation at;      ///< the model evaluated at the stage
    typename System::Factors factors;    ///< Newton matrix at this iterate or an earlier one
    StateVector<S> rows;                 ///< right side of the rows for the next solve
    /// One number per spring. The stretch by a motion (v' or a shift) is its component along the spring.
    /// `slack`: the stretch that meets no resistance in the next solve. `stretch`: the stretch by the
    /// solution x of the last solve.
    StateVector<S> slack, stretch;
    StateVector<S> stretched;  ///< stretch by the whole shift sigma_i
  };

  /// The displacements theta are computed to the relative tolerance `placed_within` [-].
  explicit RadauStages(const S& placed_within) : placed_within_(placed_within) {}

  /// Begins at a state with this v' and lambda, for a system with this number of springs.
  void begin(System& system, Eigen::Index springs, const StateVector<S>& v_dot,
             const StateVector<S>& lambda) {
    nq_ = system.position_size();
    nv_ = system.velocity_size();
    nc_ = system.multipliers();
    springs_ = springs;
    known_.fill({v_dot, lambda});
    known_h_.reset();
  }

  int nq() const { return nq_; }
  int nv() const { return nv_; }
  int nc() const { return nc_; }
  const RadauCoefficients<S, s>& coefficients() const { return coefficients_; }
  Stage& operator[](int i) { return stage_[i]; }
  const Stage& operator[](int i) const { return stage_[i]; }
  /// The stage at the end of the step.
  Stage& last() { return stage_.back(); }
  const Stage& last() const { return stage_.back(); }
  auto begin() { return stage_.begin(); }
  auto end() { return stage_.end(); }
  /// v' and lambda of the previous step's last stage.
  const Known& known() const { return known_.back(); }

  /// Predicts the stages by the polynomial through the previous step's stages. Returns false if there are
  /// none.
  bool predict(const S& h) {
    if (!known_h_) return false;
    const auto& c = coefficients_.c;
    for (int i = 0; i < s; ++i) {
      const S x = 1 + c[i] * h / *known_h_;
      std::array<S, s> weight;
      weight.fill(S(1));
      for (int j = 0; j < s; ++j)
        for (int k = 0; k < s; ++k)
          if (k != j) weight[j] *= (x - c[k]) / (c[j] - c[k]);
      begin_stage(i, mixed(weight, known_, &Known::v_dot), mixed(weight, known_, &Known::lambda));
    }
    return true;
  }
  /// All stages begin with the same v' and lambda.
  void begin_with(const StateVector<S>& v_dot, const StateVector<S>& lambda) {
    for (int i = 0; i < s; ++i) begin_stage(i, v_dot, lambda);
  }
  void show_memory(auto&& show) {
    for (Known& known : known_) show(known.v_dot, known.lambda);
    S h = known_h_.value_or(S(0));  // 0 means: no step was taken yet
    show(h);
    if (h > S(0)) known_h_ = h;
    stage_.back().lambda = known_.back().lambda;  // the method's lambda() reads it there
  }
  /// Keeps the stages of an accepted step of length h for the next prediction.
  void accept(const S& h) {
    std::copy(stage_.begin(), stage_.end(), known_.begin());
    known_h_ = h;
  }

  // Sums over the stages, weighted by a row of A, A^-1 or A^2. A sum is an Eigen expression: it reads the
  // stages only when it is assigned to a vector.
  template <class Of>
  static auto mix(const std::array<S, s>& row, const Of& of) {
    return [&]<int... j>(std::integer_sequence<int, j...>) { return (... + (row[j] * of(j))); }
    (std::make_integer_sequence<int, s>{});
  }
  template <class Part>
  auto mixed(const std::array<S, s>& row, StateVector<S> Part::*of) const {
    return mixed(row, stage_, of);
  }

  /// Computes q_i and v_i from the unknowns.
  void place(System& system, const S& h, const StateVector<S>& y, const StateVector<S>& v) {
    for (int i = 0; i < s; ++i) {
      stage_[i].v = v + h * mixed(coefficients_.a[i], &Stage::v_dot);
      stage_[i].rate =
          stage_[i].v + stage_[i].shift + stage_[i].internal_correction + stage_[i].chart_correction;
    }
    // fixed-point iteration: on a Lie group the rate of theta depends on theta itself. It ends when changes
    // no longer become smaller; 50 is a safety limit.
    S before = std::numeric_limits<S>::max();
    for (int k = 0; k < 50; ++k) {
      S moved(0), size(0);
      for (int i = 0; i < s; ++i) {
        x_ = h * mixed(coefficients_.a[i], &Stage::rate);
        if (k == 0)
          moved = before;
        else
          raise(moved, S((x_ - stage_[i].theta).norm()));
        raise(size, S(x_.norm()));
        std::swap(stage_[i].theta, x_);
      }
      if (k > 0 && (moved <= placed_within_ * size || !(moved < before))) break;
      before = moved;
      for (Stage& stage : stage_) {
        x_ = stage.v + stage.shift + stage.internal_correction;
        system.displacement_rate(stage.theta, x_, stage.rate);
        stage.chart_correction = stage.rate - x_;
      }
    }
    for (Stage& stage : stage_) {
      stage.y = y;
      system.displace(y, stage.theta, stage.y);
      stage.y.segment(nq_, nv_) = stage.v;
    }
  }
  /// Moves the stages onto the internal rows (such as |p| = 1). The corrections are multiplied by A^-1 as
  /// those of the other rows are. Only their part along the gradients of the internal rows is added: a
  /// tangential part would be a shift that no row asks for.
  void normalise(System& system, const S& h, const StateVector<S>& y, const StateVector<S>& v) {
    S before = std::numeric_limits<S>::max();
    // 20 is a safety limit
    for (int k = 0; k < 20; ++k) {
      S off(0), way(0);
      for (int i = 0; i < s; ++i) {
        Stage& stage = stage_[i];
        moved_[i].setZero(nv_);
        turned_[i].setZero(nv_);
        if (!system.normalise_step(S(1), stage.y, moved_[i])) return;
        system.normalise_step_velocity(S(1), stage.y, turned_[i]);
        off += moved_[i].norm() + h * turned_[i].norm();
        way += h * stage.v.norm();
      }
      // 2 epsilon per stage: the rounding of p, whose norm is 1, remains however short the step is
      if (off <= placed_within_ * way + 2 * s * std::numeric_limits<S>::epsilon() || !(off < before)) return;
      before = off;
      for (int i = 0; i < s; ++i) {
        Stage& stage = stage_[i];
        stage.internal_correction = normal_part(
            system, stage.internal_correction + mixed(coefficients_.inverse[i], moved_) / h - turned_[i],
            stage.y);
        stage.v_dot += normal_part(system, mixed(coefficients_.inverse[i], turned_) / h, stage.y);
      }
      place(system, h, y, v);
    }
  }
  /// Solves the linear system of every stage with its own factors, `rows` and `slack`, for the right side
  /// left(i). Passes the solution to take(i, x, mu) and stores the stretch of the springs by x in
  /// `stretch`.
  template <class Left, class Take>
  void solve_each(System& system, const Left& left, const Take& take) {
    for (int i = 0; i < s; ++i) {
      x_.setZero(nv_);
      mu_.setZero(nc_);
      system.solve(stage_[i].factors, stage_[i].at, left(i), stage_[i].rows, stage_[i].slack, x_, mu_,
                   stage_[i].stretch);
      take(i, x_, mu_);
    }
  }

 private:
  void begin_stage(int i, const auto& v_dot, const auto& lambda) {
    stage_[i].v_dot = v_dot;
    stage_[i].lambda = lambda;
    stage_[i].shift.setZero(nv_);
    stage_[i].stretched.setZero(springs_);
    stage_[i].internal_correction.setZero(nv_);
    stage_[i].chart_correction.setZero(nv_);
  }
  template <class T, class Part>
  static auto mixed(const std::array<S, s>& row, const std::array<T, s>& stages, StateVector<S> Part::*of) {
    return mix(row, [&](int j) -> const StateVector<S>& { return stages[j].*of; });
  }
  static auto mixed(const std::array<S, s>& row, const std::array<StateVector<S>, s>& stages) {
    return mix(row, [&](int j) -> const StateVector<S>& { return stages[j]; });
  }
  /// The part of a displacement along the gradients of the internal rows at y. Overwrites the velocities in
  /// y.
  template <class Displacement>
  const StateVector<S>& normal_part(System& system, const Displacement& displacement, StateVector<S>& y) {
    y.segment(nq_, nv_) = displacement;
    x_.setZero(nv_);
    system.normalise_step_velocity(S(1), y, x_);
    x_ = -x_;
    return x_;
  }

  const RadauCoefficients<S, s> coefficients_;
  const S placed_within_;
  std::array<Stage, s> stage_;
  std::array<Known, s> known_;
  std::optional<S> known_h_;  ///< length of the step that known_ comes from
  std::array<StateVector<S>, s> moved_, turned_;
  StateVector<S> x_, mu_;
  int nq_ = 0, nv_ = 0, nc_ = 0;
  Eigen::Index springs_ = 0;
};

}  // namespace trivium::integrators
