#pragma once
/// Newton's method for the equations of one implicit step of BDF, generalised-alpha and HHT. As a rule the
/// matrix is factored once per step, and Anderson acceleration makes up for the terms that the matrix leaves
/// out. This file decides when the equations count as solved, when the matrix is factored again, and when the
/// iteration diverges. It diverges if five times a correction fails to halve the residual although its matrix
/// was factored at the iterate that it corrects, or after forty iterations. With given steps a divergence
/// ends the run, with chosen ones a shorter step is tried.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "integrators/contract/errors.hpp"
#include "integrators/contract/internal_rows.hpp"
#include "integrators/contract/method.hpp"
#include "integrators/contract/newton_matrix.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/implicit/anderson.hpp"

namespace trivium::integrators {

/// When the equations of a step count as solved: `tolerance` [-] bounds the imbalance relative to the forces
/// at work. The default 1e-10 is chosen by experiment: it is far above rounding in double, and so saves the
/// last iterations. A larger value leaves larger errors of v' and lambda. The constraints are iterated to
/// rounding in any case, because an error of Phi causes an error of lambda that is 1 / h^2 times as large. If
/// rounding prevents this, up to 1000 times both bounds is accepted. So is any imbalance whose correction
/// changes velocities by no more than their rounding: it is no small part of the forces where these fade
/// away.
struct NewtonOptions {
  double tolerance = 1e-10;
  bool is_full = false;  ///< factor in every iteration; else once per step, and again where needed
};

/// The unknowns of a step; they begin as predicted. With index 3, v' is determined by the position rows, and
/// `shift` is empty. With the stabilised index 2, v' is determined by the velocity rows, and `shift` moves
/// the positions onto their rows.
template <class S>
struct StepUnknowns {
  StateVector<S> v_dot, lambda, shift;
};

/// Throws an IntegrationError that names the row which the last iterate violates, or says that forces do not
/// balance.
template <HasResidual System>
[[noreturn]] void throw_not_converged(const System& system, const typename System::Scalar& t,
                                      const Violation<typename System::Scalar>& violation) {
  using S = typename System::Scalar;
  // half of a double's digits: a divergent iteration is far above, rounding far below
  constexpr double met = 1e-8;
  const bool of_rows = !(violation.relative <= S(met));
  throw IntegrationError({of_rows ? fmt::format("row \"{}\"", system.row_name(violation.row)) : std::string(),
                          static_cast<double>(t)},
                         fmt::format("Newton's method does not converge: {}; take smaller steps",
                                     of_rows ? "this constraint row stays violated"
                                             : "the equations of motion stay unbalanced"));
}

/// Newton's method for one step after another. `filter` uses the matrix that was factored last.
template <HasNewtonMatrix System>
requires HasInternalRows<System>
class Newton {
 public:
  using S = typename System::Scalar;

  explicit Newton(const NewtonOptions& options) : options_(options) {}

  /// Solves the equations of a step to time t. `place(x, y)` sets y to the state that follows from the
  /// unknowns x. Throws an IntegrationError that names the row which is not met, or says that forces do not
  /// balance.
  template <class Place>
  void operator()(System& system, const S& t, const Shares<S>& shares, const Place& place, StateVector<S>& y,
                  StepUnknowns<S>& x, Counters& counters) {
    const bool is_stabilised = x.shift.size() > 0;
    const Eigen::Index nv = x.v_dot.size(), nc = x.lambda.size();
    bool is_fresh = false;
    Violation<S> violation;
    anderson_.clear();
    system.clear_dependent(x.lambda);
    const S none = std::numeric_limits<S>::max();
    S before = none, least = none;
    for (int k = 0, rises = 0; k < most_iterations && rises < most_rises; ++k) {
      place(x, y);
      if (is_stabilised) {
        if (system.normalise_step(S(1), y, x.shift)) {
          system.normalise_step_velocity(shares.velocity, y, x.v_dot);
          place(x, y);
        }
      } else {
        unnormalised_ = x.v_dot;
        if (system.normalise_step(shares.position, y, x.v_dot)) {
          if ((shares.position * (x.v_dot - unnormalised_).array().abs() <= last_digit()).all())
            x.v_dot = unnormalised_;
          place(x, y);
        }
      }
      if (!x.v_dot.allFinite() || !x.lambda.allFinite()) break;
      system.evaluate(t, y, at_);
      system.inertia_force(at_, x.v_dot, force_);
      const S imbalance = system.residual(at_, force_, x.lambda, left_);
      ++counters.right_sides;
      violation = system.position_rows(at_, phi_);
      if (is_stabilised) raise(violation, Violation<S>(system.velocity_rows(at_, phi_dot_)));
      if (imbalance <= enough() && violation.relative <= rounding<S>()) return;
      // `is_fresh`: the matrix of the last correction was factored at the iterate that it corrected. If even
      // such a correction does not halve the residual, rounding is reached or the iteration diverges. Up to
      // 1000 times the bounds (a safety factor) it counts as rounding the second time, and the best iterate
      // is taken: near a singular position the rounding of a correction can exceed the residual that it
      // removes. At the first time the iterate may still be far from the best, which lambda of index 3 shows.
      const S now = imbalance / enough() + violation.relative / rounding<S>();
      const bool falls = now <= before / 2;
      const bool is_best = imbalance < least && violation.relative <= S(1e3) * rounding<S>();
      if (is_best) {
        least = imbalance;
        best_ = x;
      }
      if (!falls && is_fresh) {
        if (rises > 0 &&
            (least <= S(1e3) * enough() || (least < none && is_rounding(system, shares, y, x)))) {
          if (is_best) return;
          x = best_;
          place(x, y);
          system.evaluate(t, y, at_);
          return;
        }
        ++rises;
      }
      before = now;
      is_fresh = k == 0 || options_.is_full || (!falls && !is_fresh);
      if (is_fresh) {
        system.factor(at_, shares, factors_);
        has_factors_ = true;
        if (!options_.is_full) anderson_.clear();
      }
      change_.resize(nv + nc + x.shift.size());
      v_change_.setZero(nv);
      if (is_stabilised) {
        // The change of v' that meets the velocity rows also changes Phi, in proportion; the shift corrects
        // the rest.
        phi_ = shares.position / shares.velocity * phi_dot_ - phi_;
        mu_.setZero(nc);
        no_force_.setZero(nv);
        system.solve(factors_, at_, no_force_, phi_, v_change_, mu_);
        change_.tail(nv) = v_change_;
        v_change_.setZero(nv);
        phi_dot_ /= -shares.velocity;
      } else if (violation.relative <= last_digit()) {
        phi_.setZero();
      } else {
        phi_ /= -shares.position;
      }
      lambda_change_.setZero(nc);
      system.solve(factors_, at_, left_, is_stabilised ? phi_dot_ : phi_, v_change_, lambda_change_);
      change_.head(nv) = v_change_;
      change_.segment(nv, nc) = lambda_change_;
      const StateVector<S>& step = anderson_.step(change_, nv);
      x.v_dot += step.head(nv);
      x.lambda += step.segment(nv, nc);
      if (is_stabilised) x.shift += step.tail(nv);
      ++counters.iterations;
    }
    throw_not_converged(system, t, violation);
  }
  /// The model at the last iterate.
  const typename System::Evaluation& at() const { return at_; }
  /// Factors the matrix of M and Phi_q alone at (t, y), for `filter`.
  void factor(System& system, const S& t, const StateVector<S>& y) {
    system.evaluate(t, y, at_);
    phi_.resize(system.multipliers());
    system.factor(at_, {}, factors_);
    has_factors_ = true;
  }
  /// Removes from a change of the motion the part that the rows do not admit, and damps the part that stiff
  /// springs resist, by the matrix that was factored last. Does nothing before the first one.
  void filter(System& system, StateVector<S>& change) {
    if (!has_factors_) return;
    system.inertia_force(factors_, change, force_);
    system.reduce(factors_, force_, left_);
    change.setZero();
    mu_.setZero(phi_.size());
    no_rows_.setZero(phi_.size());
    system.solve(factors_, at_, left_, no_rows_, change, mu_);
  }
  /// Changes the velocities of y at time t such that they miss their rows by `share` times as much as before,
  /// by the matrix that was factored last. With index 3 velocities miss their rows by c h^2. A step of
  /// another length must begin with the violation that belongs to its length, else lambda oscillates.
  void scale_velocity_violation(System& system, const S& t, const S& share, StateVector<S>& y) {
    if (!has_factors_) return;
    system.evaluate(t, y, at_);
    system.velocity_rows(at_, phi_dot_);
    phi_dot_ *= share - 1;
    v_change_.setZero(system.velocity_size());
    mu_.setZero(phi_dot_.size());
    no_force_.setZero(v_change_.size());
    system.solve(factors_, at_, no_force_, phi_dot_, v_change_, mu_);
    y.segment(system.position_size(), v_change_.size()) += v_change_;
  }

 private:
  /// Chosen by experiment. Less would give up slow iterations; more only delays the end of divergent ones.
  static constexpr int most_iterations = 40, most_rises = 5;

  /// Whether the last correction changed velocities and multipliers by rounding: velocities by up to
  /// four last digits, multipliers by what is accepted of forces.
  bool is_rounding(const System& system, const Shares<S>& shares, const StateVector<S>& y,
                   const StepUnknowns<S>& x) const {
    const auto v = y.segment(system.position_size(), v_change_.size()).array();
    const S of_lambda = S(1e3) * enough() * x.lambda.template lpNorm<Eigen::Infinity>();
    return (shares.velocity * v_change_.array().abs() <= 4 * last_digit() * v.abs()).all() &&
           (lambda_change_.array().abs() <= of_lambda).all();
  }

  /// A violation of rows that is left, for a division by h^2 would turn it into a large v'.
  static S last_digit() { return std::numeric_limits<S>::epsilon(); }
  S enough() const { return std::max(S(options_.tolerance), rounding<S>()); }

  NewtonOptions options_;
  Anderson<S> anderson_;
  typename System::Evaluation at_;
  typename System::Factors factors_;
  bool has_factors_ = false;
  StepUnknowns<S> best_;
  StateVector<S> unnormalised_;
  StateVector<S> force_, left_, phi_, phi_dot_;
  StateVector<S> change_, v_change_, lambda_change_, mu_, no_force_, no_rows_;
};

}  // namespace trivium::integrators
