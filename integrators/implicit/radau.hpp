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
/// with M and Phi_q of the last from Newton's matrix, what springs resist included. That is real for each
/// stage, made where that stage is, as stiff springs turn within a step. Rows are met through A^-1. Springs
/// resist in it by the share h gamma of A's real eigenvalue; what they do from stage to stage through A is
/// solved for in their own few numbers, without evaluating anything. To tolerances, it ends where the changes
/// still to come are small by those that came. Order s in its own lambda.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "integrators/implicit/conjugate_residuals.hpp"
#include "integrators/implicit/newton.hpp"
#include "integrators/implicit/radau_coefficients.hpp"
#include "integrators/initial_acceleration.hpp"
#include "integrators/step_size_control.hpp"

namespace trivium::integrators {

/// Of an odd number of stages.
template <ConstrainedSystem System, int s>
class Radau {
 public:
  using S = typename System::Scalar;

  /// Steps of its own choice to the tolerances, or of the grid's length.
  Radau(std::optional<Tolerances> tolerances, const NewtonOptions& newton)
      : tolerances_(tolerances), newton_(newton) {
    // errors of order 9 are soon below what a balance to 1e-10 leaves
    if (tolerances || s > 3) newton_.tolerance = 0;
    if (!tolerances) return;
    // changes say when to end, beside the errors that tolerances are about; forces would not
    stalled_ = std::min(stalled_, 10 * tolerances->rtol);
    most_to_come_ = 0.03 * std::min(1.0, std::pow(tolerances->rtol / 1e-3, 0.25));
  }

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    if (!has_begun_) begin(system, t, y, stop);
    if (!tolerances_) {
      advance(system, t, stop - t, y);
      accept(stop - t, y);
      t = stop;
      return;
    }
    system.position_sizes(y, sizes_);
    take_chosen_step(
        system, choice_, {S(-1) / (s + 1), S(8)}, counters_, t, y, stop,
        [&](const S& h) {
          const S error = advance(system, t, h, y);
          if (error <= S(1)) meet_rows(system, S(t + h), stage_.back().y);
          return error;
        },
        [&](const S& h) { accept(h, y); });
  }
  void restart() {
    has_begun_ = false;
    choice_.restart();
    ++counters_.restarts;
  }
  bool shorten() {
    if (!tolerances_) return false;
    has_begun_ = false;
    choice_.shorten();
    --counters_.steps;
    ++counters_.rejected_steps;
    return true;
  }
  const Counters& counters() const { return counters_; }
  const StateVector<S>* lambda() const { return has_begun_ ? &stage_.back().lambda : nullptr; }

 private:
  /// What the next step goes on from.
  struct Known {
    StateVector<S> v_dot, lambda;
  };
  struct Stage : Known {
    StateVector<S> shift;               ///< the third unknown
    StateVector<S> normal;              ///< the share in it that internal rows have
    StateVector<S> v, theta, rate, y;   ///< where they lead
    StateVector<S> bend;                ///< by how much theta's rate is not v + shift + normal
    StateVector<S> left, phi, phi_dot;  ///< what is left to solve
    StateVector<S> made_at;             ///< the state that the matrix is of
    StateVector<S> rows;                ///< asked of it
    StateVector<S> slack, stretch;      ///< of springs, with the last change
    StateVector<S> stretched;           ///< by the shift
  };

  void begin(System& system, const S& t, const StateVector<S>& y, const S& stop) {
    nq_ = system.position_size();
    nv_ = system.velocity_size();
    nc_ = system.multipliers();
    system.spring_constants(stiffness_, damping_);
    const S h = stop - t;
    const Start<S> start(system, t, y, tolerances_ ? h / 1000 : h, counters_);
    last_.fill({start.v_dot, start.lambda});
    last_h_.reset();
    has_matrix_ = false;
    if (tolerances_ && !choice_.has_begun())
      choice_.begin(first_step(system, t, y, s, *tolerances_, counters_.right_sides));
    has_begun_ = true;
  }

  /// Solves the stages of a step; y stays. Returns the estimated error, in tolerances.
  S advance(System& system, const S& t, const S& h, const StateVector<S>& y) {
    const auto solved = [&] { return solve_stages(system, t, h, y); };
    const auto solved_from = [&](const StateVector<S>& v_dot) {
      for (int i = 0; i < s; ++i) begin_stage(i, v_dot, last_.back().lambda);
      return solved();
    };
    // after a transient what the last stages foretell may be far off, and in one even what they end with
    if (!(predict(h) && solved()) && !solved_from(last_.back().v_dot) &&
        !solved_from(StateVector<S>::Zero(nv_)))
      throw_not_converged(system, t);
    return error_of(system, h, y);
  }

  /// From the stages as predicted; whether they came to solve their equations.
  bool solve_stages(System& system, const S& t, const S& h, const StateVector<S>& y) {
    const StateVector<S> v = y.segment(nq_, nv_);
    anderson_.clear();
    S before = std::numeric_limits<S>::max(), moved_before = before, moved_earlier = before;
    const S enough = std::max(S(newton_.tolerance), rounding<S>()),
            stalled = std::max(S(stalled_), S(1000 * rounding<S>()));
    // the matrix is made for the first iteration and, from where changes do not halve, for every one
    bool is_fresh = false, at_each = newton_.is_full;
    const auto refresh = [&] {
      if (!std::exchange(at_each, true)) anderson_.clear();
    };
    for (int k = 0, rises = 0; k < 40 && rises < 5; ++k) {
      place(system, h, y, v);
      normalise(system, h, y, v);
      S imbalance(0), violation(0);
      for (int i = 0; i < s; ++i) {
        Stage& stage = stage_[i];
        system.select(i);
        if (!stage.v_dot.allFinite() || !stage.lambda.allFinite()) return false;
        system.inertia_force(stage.y, stage.v_dot, force_);
        imbalance = std::max(imbalance,
                             S(system.residual(t + coefficients_.c[i] * h, stage.y, force_, stage.lambda)));
        ++counters_.right_sides;
        violation = std::max(violation, S(system.relative_row_violation()));
        system.row_residual(stage.phi);
        violation = std::max(violation, S(system.velocity_rows()));
        system.row_residual(stage.phi_dot);
        system.force_residual(stage.left);
        stage_work_[i] = y.size() > nq_ + nv_ ? S(system.work_rate(stage.lambda)) : S(0);
      }
      const S now = imbalance / enough + violation / rounding<S>();
      if (imbalance <= enough && violation <= rounding<S>()) return true;
      const bool falls = now <= before / 2;
      if (!falls) {
        // forces of bodies far lighter than others are none beside theirs, but changes tell of them too
        const bool is_still = !tolerances_ || moved_before <= S(1);
        if (is_fresh && is_still && imbalance <= stalled && violation <= 1000 * rounding<S>()) return true;
        ++rises;
        refresh();
      }
      before = now;
      is_fresh = k == 0 || at_each;
      const StateVector<S>& step = correct(system, h, is_fresh);
      ++counters_.iterations;
      if (!tolerances_) continue;
      const S moved = size_of(step, h, y);
      // how changes fell, of the last one and of the last two: one alone may be small by chance
      using std::sqrt;
      const S share =
          k == 0 ? S(1) : std::max(S(moved / moved_before), k == 1 ? S(0) : S(sqrt(moved / moved_earlier)));
      if (k > 0 && (moved == S(0) || (moved <= S(1) && moved * share <= most_to_come_ * (1 - share)))) {
        place(system, h, y, v);
        normalise(system, h, y, v);
        return true;
      }
      if (moved > moved_before / 2) refresh();
      moved_earlier = moved_before;
      moved_before = moved;
    }
    return false;
  }

  /// At the end of a step, where the stages met their rows within tolerances. Throws if they cannot be.
  void meet_rows(System& system, const S& t, StateVector<S>& y) {
    system.select(s - 1);
    x_.setZero(nv_);
    system.normalise_step(S(1), y, x_);
    const auto meet = [&](const auto& violation, const auto& move) {
      S before = std::numeric_limits<S>::max(), now = violation();
      for (; now > rounding<S>() && now < before; now = violation()) {
        before = now;
        system.row_residual(rows_);
        x_.setZero(nv_);
        mu_.setZero(nc_);
        system.solve(StateVector<S>::Zero(nv_), -rows_, x_, mu_);
        move();
      }
      if (!(now <= 1000 * rounding<S>())) throw_not_converged(system, t);
    };
    meet([&] { return S(system.position_rows(t, y)); },
         [&] {
           const StateVector<S> from = y;
           system.displace(from, x_, y);
           system.normalise_step(S(1), y, x_);
         });
    x_.setZero(nv_);
    system.normalise_step_velocity(S(1), y, x_);
    y.segment(nq_, nv_) += x_;
    meet(
        [&] {
          system.position_rows(t, y);
          return S(system.velocity_rows());
        },
        [&] { y.segment(nq_, nv_) += x_; });
  }

  /// On from the last step's stages, by the polynomial through them; false where there are none.
  bool predict(const S& h) {
    if (!last_h_) return false;
    const auto& c = coefficients_.c;
    for (int i = 0; i < s; ++i) {
      const S x = 1 + c[i] * h / *last_h_;
      std::array<S, s> weight;
      weight.fill(S(1));
      for (int j = 0; j < s; ++j)
        for (int k = 0; k < s; ++k)
          if (k != j) weight[j] *= (x - c[k]) / (c[j] - c[k]);
      begin_stage(i, mixed(weight, last_, &Known::v_dot), mixed(weight, last_, &Known::lambda));
    }
    return true;
  }
  void begin_stage(int i, const StateVector<S>& v_dot, const StateVector<S>& lambda) {
    stage_[i].v_dot = v_dot;
    stage_[i].lambda = lambda;
    stage_[i].shift.setZero(nv_);
    stage_[i].stretched.setZero(stiffness_.size());
    stage_[i].normal.setZero(nv_);
    stage_[i].bend.setZero(nv_);
  }

  // expressions, of the stages as they are when it is taken
  template <class Of>
  static auto mix(const std::array<S, s>& row, const Of& of) {
    return [&]<int... j>(std::integer_sequence<int, j...>) { return (... + (row[j] * of(j))); }
    (std::make_integer_sequence<int, s>{});
  }
  template <class T, class Part>
  static auto mixed(const std::array<S, s>& row, const std::array<T, s>& stages, StateVector<S> Part::*of) {
    return mix(row, [&](int j) -> const StateVector<S>& { return stages[j].*of; });
  }
  static auto mixed(const std::array<S, s>& row, const std::array<StateVector<S>, s>& stages) {
    return mix(row, [&](int j) -> const StateVector<S>& { return stages[j]; });
  }
  template <class Part>
  auto mixed(const std::array<S, s>& row, StateVector<S> Part::*of) const {
    return mixed(row, stage_, of);
  }

  void place(System& system, const S& h, const StateVector<S>& y, const StateVector<S>& v) {
    for (int i = 0; i < s; ++i) {
      stage_[i].v = v + h * mixed(coefficients_.a[i], &Stage::v_dot);
      stage_[i].rate = stage_[i].v + stage_[i].shift + stage_[i].normal + stage_[i].bend;
    }
    // theta depends on its own rate where positions are a group
    S before = std::numeric_limits<S>::max();
    for (int k = 0; k < 50; ++k) {
      S moved(0), size(0);
      for (int i = 0; i < s; ++i) {
        x_ = h * mixed(coefficients_.a[i], &Stage::rate);
        moved = k == 0 ? before : std::max(moved, S((x_ - stage_[i].theta).norm()));
        size = std::max(size, S(x_.norm()));
        std::swap(stage_[i].theta, x_);
      }
      if (k > 0 && (moved <= placed_within() * size || !(moved < before))) break;
      before = moved;
      for (Stage& stage : stage_) {
        x_ = stage.v + stage.shift + stage.normal;
        system.displacement_rate(stage.theta, x_, stage.rate);
        stage.bend = stage.rate - x_;
      }
    }
    for (Stage& stage : stage_) {
      stage.y = y;
      system.displace(y, stage.theta, stage.y);
      stage.y.segment(nq_, nv_) = stage.v;
    }
  }
  /// Of displacements, beside their own size: many short steps then miss no more than a few long ones.
  S placed_within() const {
    return std::max(2 * std::numeric_limits<S>::epsilon(), tolerances_ ? S(1e-3 * tolerances_->rtol) : S(0));
  }
  /// Rows that a model keeps to itself, through A^-1 as the others; at each stage by what is normal to them,
  /// as what is along them would be a shift that nobody asks for.
  void normalise(System& system, const S& h, const StateVector<S>& y, const StateVector<S>& v) {
    S before = std::numeric_limits<S>::max();
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
      if (off <= placed_within() * way + 2 * s * std::numeric_limits<S>::epsilon() || !(off < before)) return;
      before = off;
      for (int i = 0; i < s; ++i) {
        Stage& stage = stage_[i];
        stage.normal = normal_part(
            system, stage.normal + mixed(coefficients_.inverse[i], moved_) / h - turned_[i], stage.y);
        stage.v_dot += normal_part(system, mixed(coefficients_.inverse[i], turned_) / h, stage.y);
      }
      place(system, h, y, v);
    }
  }
  /// Of a displacement, to the internal rows at y, whose velocities are lost.
  template <class Displacement>
  const StateVector<S>& normal_part(System& system, const Displacement& displacement, StateVector<S>& y) {
    y.segment(nq_, nv_) = displacement;
    x_.setZero(nv_);
    system.normalise_step_velocity(S(1), y, x_);
    x_ = -x_;
    return x_;
  }

  const StateVector<S>& correct(System& system, const S& h, bool makes_matrix) {
    if (makes_matrix) factor(system, h);
    const Eigen::Index springs = stiffness_.size(), behind = s * (2 * nv_ + nc_);
    change_.setZero(behind + s * springs);
    for (int i = 0; i < s; ++i) {
      stage_[i].slack = -stage_[i].stretched;
      stage_[i].rows = stage_[i].phi_dot + mixed(coefficients_.inverse[i], &Stage::phi) / -h;
    }
    no_force_.setZero(nv_);
    solve_each(
        system,
        [&](int i) -> const StateVector<S>& {
          // what of the shift is along the rows goes, springs too being in the way
          system.inertia_force(stage_[i].made_at, stage_[i].shift, force_);
          system.take_force(-force_, along_);
          return along_;
        },
        [&](int i) {
          change_.segment(s * (nv_ + nc_) + i * nv_, nv_) = x_;
          change_.segment(behind + i * springs, springs) = stage_[i].stretch;
          stage_[i].slack.setZero();
        });
    solve_together(system, h);
    const StateVector<S>& step = anderson_.step(change_, s * nv_);
    for (int i = 0; i < s; ++i) {
      stage_[i].v_dot += step.segment(i * nv_, nv_);
      stage_[i].lambda += step.segment(s * nv_ + i * nc_, nc_);
      stage_[i].shift += step.segment(s * (nv_ + nc_) + i * nv_, nv_);
      stage_[i].stretched += step.segment(behind + i * springs, springs);
    }
    return step;
  }
  /// How far a correction moves the stages, in tolerances.
  S size_of(const StateVector<S>& step, const S& h, const StateVector<S>& y) {
    const auto of_v_dot = [&](int j) { return step.segment(j * nv_, nv_); },
               of_shift = [&](int j) { return step.segment(s * (nv_ + nc_) + j * nv_, nv_); };
    S largest(0);
    for (int i = 0; i < s; ++i) {
      x_ = h * mix(coefficients_.a[i], of_v_dot);
      force_ = h * h * mix(coefficients_.square[i], of_v_dot) + h * mix(coefficients_.a[i], of_shift);
      largest = std::max(largest, in_tolerances(y, force_, x_));
    }
    return largest;
  }
  /// A displacement with a change of velocities, in tolerances.
  S in_tolerances(const StateVector<S>& y, const StateVector<S>& of_q, const StateVector<S>& of_v) const {
    using std::abs, std::sqrt;
    const S atol(tolerances_->atol), rtol(tolerances_->rtol);
    S sum(0);
    for (int k = 0; k < nv_; ++k) {
      const S v = of_v[k] / (atol + rtol * std::max(S(abs(y[nq_ + k])), S(abs(stage_.back().v[k])))),
              q = of_q[k] / (atol + rtol * sizes_[k]);
      sum += v * v + q * q;
    }
    return sqrt(sum / (2 * nv_));
  }
  void factor(System& system, const S& h) {
    const S share = h * coefficients_.gamma;
    for (int i = 0; i < s; ++i) {
      system.select(i);
      system.factor(share, S(share * share));
      stage_[i].made_at = stage_[i].y;
    }
    slackenings_.clear();
    resistance_ = share * damping_ + share * share * stiffness_;
    has_matrix_ = true;
  }
  /// Of each stage's own matrix, for its rows and slacks; take(i) finds what solves them in x_ and mu_.
  template <class Left, class Take>
  void solve_each(System& system, const Left& left, const Take& take) {
    for (int i = 0; i < s; ++i) {
      x_.setZero(nv_);
      mu_.setZero(nc_);
      system.select(i);
      system.solve(left(i), stage_[i].rows, stage_[i].slack, x_, mu_, stage_[i].stretch);
      take(i);
    }
  }
  /// What the stages' v' and lambda change by. The matrix resists by a share of each stage's own stretch what
  /// A mixes from all: slacks make up for the difference, and what they do is known as long as the factors.
  void solve_together(System& system, const S& h) {
    const Eigen::Index springs = stiffness_.size();
    given_.resize(s * springs);
    for (int i = 0; i < s; ++i) {
      // what the positions' own change stretches springs by
      given_.segment(i * springs, springs) =
          h * stiffness_.cwiseProduct(mixed(coefficients_.a[i], &Stage::stretch));
      stage_[i].rows = mixed(coefficients_.inverse[i], &Stage::phi_dot) / -h;
    }
    const auto put_into = [this](StateVector<S>& change) {
      return [this, &change](int i) {
        change.segment(i * nv_, nv_) = x_;
        change.segment(s * nv_ + i * nc_, nc_) = mu_;
      };
    };
    solve_each(
        system, [&](int i) -> const StateVector<S>& { return stage_[i].left; }, put_into(change_));
    if (springs == 0) return;
    measure_missed(h, missed_);
    missed_ -= given_;
    const S enough = S(1e-2) * std::max(missed_.cwiseAbs().maxCoeff(), given_.cwiseAbs().maxCoeff());
    auto change = change_.head(s * (nv_ + nc_));
    slackenings_.reduce(missed_, change);
    for (Stage& stage : stage_) stage.rows.setZero();
    direction_.resize(s * (nv_ + nc_));
    for (int k = 0; k < most_slackenings && missed_.cwiseAbs().maxCoeff() > enough; ++k) {
      for (int i = 0; i < s; ++i)
        stage_[i].slack = missed_.segment(i * springs, springs).cwiseQuotient(resistance_);
      solve_each(
          system, [&](int) -> const StateVector<S>& { return no_force_; }, put_into(direction_));
      measure_missed(h, image_);
      if (!slackenings_.keep(direction_, image_)) break;
      slackenings_.reduce(missed_, change);
    }
  }
  /// By how much the matrix resists more than A asks for [N, N m].
  void measure_missed(const S& h, StateVector<S>& missed) {
    const Eigen::Index springs = stiffness_.size();
    missed.resize(s * springs);
    for (int i = 0; i < s; ++i)
      missed.segment(i * springs, springs) =
          resistance_.cwiseProduct(stage_[i].stretch - stage_[i].slack) -
          h * damping_.cwiseProduct(mixed(coefficients_.a[i], &Stage::stretch)) -
          h * h * stiffness_.cwiseProduct(mixed(coefficients_.square[i], &Stage::stretch));
  }

  /// Of order s, filtered by the matrix of springs: what it would damp is no error.
  S error_of(System& system, const S& h, const StateVector<S>& y) {
    if (!tolerances_) return S(0);
    // where the stages were as predicted, none was asked for
    if (!has_matrix_) factor(system, h);
    const StateVector<S> v = y.segment(nq_, nv_);
    const auto& e = coefficients_.error;
    const S& gamma = coefficients_.gamma;
    StateVector<S> off_v = gamma * h * last_.back().v_dot;
    for (int i = 0; i < s; ++i) off_v += e[i] * (stage_[i].v - v);
    const StateVector<S> off_q = gamma * h * v + mixed(e, &Stage::theta);
    system.inertia_force(y, off_v, force_);
    x_.setZero(nv_);
    mu_.setZero(nc_);
    system.solve_force(force_, x_, mu_);
    return in_tolerances(y, off_q, x_);
  }

  void accept(const S& h, StateVector<S>& y) {
    const S work = y.size() > nq_ + nv_ ? y[nq_ + nv_] : S(0);
    y = stage_.back().y;
    if (y.size() > nq_ + nv_)
      y[nq_ + nv_] = work + h * mix(coefficients_.a.back(), [&](int j) { return stage_work_[j]; });
    std::copy(stage_.begin(), stage_.end(), last_.begin());
    last_h_ = h;
    ++counters_.steps;
  }

  static constexpr int most_slackenings = 4 * s;

  const RadauCoefficients<S, s> coefficients_;
  std::optional<Tolerances> tolerances_;
  NewtonOptions newton_;
  double stalled_ = 1e-7;  ///< imbalance that rounding may leave
  S most_to_come_{0};      ///< of Newton's changes, in tolerances; less where there are more steps
  StepSizeControl<S> choice_;
  Anderson<S> anderson_;
  ConjugateResiduals<S> slackenings_;
  std::array<Stage, s> stage_;
  std::array<Known, s> last_;
  std::array<StateVector<S>, s> moved_, turned_;
  std::array<S, s> stage_work_;
  std::optional<S> last_h_;
  StateVector<S> force_, along_, change_, rows_, x_, mu_, no_force_, stiffness_, damping_, resistance_;
  StateVector<S> sizes_;                               ///< of what displacements move
  StateVector<S> given_, missed_, direction_, image_;  ///< of springs, stage by stage
  int nq_ = 0, nv_ = 0, nc_ = 0;
  bool has_begun_ = false, has_matrix_ = false;
  Counters counters_;
};

template <ConstrainedSystem System>
using Radau5 = Radau<System, 3>;
template <ConstrainedSystem System>
using Radau9 = Radau<System, 5>;

}  // namespace trivium::integrators
