#pragma once
/// RATTLE on a Lie group: the variational integrator of the discrete Lagrangian h (1/2 Omega^T M Omega - V),
/// with q_n+1 = q_n o exp(theta), theta = h Omega, and constraints on positions and velocities. It has order
/// 2 and is symplectic if the forces have a potential. Hairer, Lubich and Wanner, Geometric Numerical
/// Integration (2006), VII.1 and VII.5; Lee, Leok and McClamroch, Computer Methods in Applied Mechanics and
/// Engineering 196 (2007).
///
///   T(theta)^-1 M theta / h = M v_n + h/2 (f_n - Phi_q^T lambda_n),      Phi(q_n+1, t_n+1) = 0
///   M v_n+1 = T(-theta)^-1 M theta / h + h/2 (f_n+1 - Phi_q^T mu_n+1),    Phi_q v_n+1 = nu
///
/// T(theta)^-1 is displacement_rate of the system. f is the applied force; T contains the gyroscopic terms.
/// The composition of five such steps (Suzuki, Physics Letters A 146 (1990)) has order 4. All five begin and
/// end within the whole step. A step that ends at an event, such as a jump of a force, therefore evaluates no
/// force from beyond the event. The method's own multipliers are mu_n+1, corrected by an error estimate from
/// mu_n and lambda_n; they have order 2. The work is integrated by the trapezoidal rule over each step of the
/// composition, which has the order of the method.

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "integrators/contract/errors.hpp"
#include "integrators/contract/newton_matrix.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/implicit/anderson.hpp"
#include "integrators/initial_acceleration.hpp"
#include "integrators/work_quadrature.hpp"

namespace trivium::integrators {

/// RATTLE of order 2 or 4 with given steps. A step throws a UsageError if M depends on positions.
template <HasNewtonMatrix System>
class Rattle {
 public:
  using S = typename System::Scalar;

  /// The order is 2 or 4.
  explicit Rattle(int order) : is_composed_(order == 4) {}

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    using std::pow;
    if (!system.inertia_is_constant())
      throw UsageError("rattle needs a formulation whose mass matrix does not depend on positions");
    const S h = stop - t;
    if (!has_begun_) begin(system, t, y, stop);
    if (is_composed_) {
      // each part begins where the one before ends: of late times, t + 2 part + back is not stop - 2 part
      const S part = 1 / (4 - pow(S(4), S(1) / 3)) * h;
      advance(system, t, S(t + part), y);
      advance(system, S(t + part), S(t + 2 * part), y);
      advance(system, S(t + 2 * part), S(stop - 2 * part), y);
      advance(system, S(stop - 2 * part), S(stop - part), y);
      advance(system, S(stop - part), stop, y);
    } else {
      advance(system, t, stop, y);
    }
    t = stop;
    ++counters_.steps;
  }
  void restart() {
    has_begun_ = false;
    ++counters_.restarts;
  }
  bool shorten() { return false; }
  const Counters& counters() const { return counters_; }
  const StateVector<S>* lambda() const { return has_begun_ ? &memory_.lambda : nullptr; }

  /// The numbers that are kept from step to step.
  struct Memory {
    StateVector<S> held, lambda;  ///< force [N, N m] and multipliers of the constraints at the last state
    S last_h{0};                  ///< length of the last step [s]
    WorkQuadrature<S> work;
  };
  const Memory& memory() const { return memory_; }
  /// Goes on from (t, y) with the memory that the method had there.
  void recall(System& system, const S& t, const StateVector<S>& y, const Memory& memory) {
    memory_ = memory;
    system.evaluate(t, y, at_);
    factor(system);
  }

  bool has_begun() const { return has_begun_; }
  void begin(System& system, const S& t, const StateVector<S>& y, const S& stop) {
    const InitialAcceleration<S> start(system, t, y, stop - t, counters_);
    none_.setZero(system.velocity_size());
    memory_.lambda = start.lambda;
    memory_.last_h = S(0);
    // memory_.held = -Phi_q^T lambda, as the difference of the residuals with and without multipliers
    system.evaluate(t, y, at_);
    system.residual(at_, none_, memory_.lambda, memory_.held);
    system.residual(at_, none_, StateVector<S>::Zero(system.multipliers()), left_);
    memory_.held -= left_;
    factor(system);
    memory_.work.begin(start.work_rate);
    has_begun_ = true;
  }
  void show_memory(auto&& show) {
    memory_.work.show_memory(show);
    show(memory_.held, memory_.lambda, memory_.last_h);
  }

 private:
  void advance(System& system, const S& t, const S& t_next, StateVector<S>& y) {
    const S h = t_next - t;
    const int nq = system.position_size(), nv = system.velocity_size();
    from_ = y;
    v_ = y.segment(nq, nv);
    system.evaluate(t, y, at_);
    system.applied_force(at_, force_);
    system.inertia_force(at_, v_, momentum_);
    known_ = h * momentum_ + h * h / 2 * (force_ + memory_.held);
    theta_ = h * v_;
    mu_.setZero(system.multipliers());
    const S length = h > S(0) ? h : S(-h);  // a composed step has one part that goes back
    const S size = length * momentum_.norm() + h * h / 2 * (force_.norm() + memory_.held.norm());
    approach(
        system, t_next, S(most_left_of_positions),
        [&] {
          size_ = size + known_.norm();
          system.displace(from_, theta_, y);
          system.evaluate(t_next, y, at_);
          system.inertia_force(at_, theta_, momentum_);
          system.displacement_rate(theta_, momentum_, rate_);
          left_ = known_ - rate_;
          return system.position_rows(at_, rows_);
        },
        [&] {
          theta_ += change_;
          known_ += force_change_;
        });
    // The error of mu_n is c memory_.last_h with an unknown factor c, where memory_.last_h is the length of
    // the step before t_n. The error of lambda_n is -c h. The iteration above has found 2 / h^2 mu_ =
    // lambda_n - mu_n, which is therefore -c (h + memory_.last_h). Hence off_ = -c h, and memory_.lambda =
    // mu_n+1 + off_ has no error of order h.
    off_ = h / (h + memory_.last_h) * 2 / (h * h) * mu_;
    system.inertia_force(at_, theta_, momentum_);
    y.segment(nq, nv) = theta_ / h;
    theta_ = -theta_;
    system.displacement_rate(theta_, momentum_, rate_);
    arriving_ = rate_ / h;
    system.evaluate(t_next, y, at_);
    factor(system);
    memory_.held.setZero(nv);
    mu_.setZero();
    approach(
        system, t_next, S(most_left_of_velocities),
        [&] {
          system.evaluate(t_next, y, at_);
          system.applied_force(at_, force_);
          size_ = arriving_.norm() + length / 2 * (force_.norm() + memory_.held.norm());
          v_ = y.segment(nq, nv);
          left_ = arriving_ + h / 2 * (force_ + memory_.held) - momentum_of(system, v_);
          return system.velocity_rows(at_, rows_);
        },
        [&] {
          y.segment(nq, nv) += change_;
          memory_.held += 2 / h * force_change_;
        });
    memory_.last_h = h;
    memory_.lambda = 2 / h * mu_ + off_;
    if (y.size() == nq + nv) return;
    system.derivative(t_next, y, y_dot_);
    ++counters_.right_sides;
    memory_.work.add(y_dot_[nq + nv], h, y[nq + nv]);
  }

  /// Solves one half of the step to rounding, with the factors made last. `look` puts the residual of the
  /// momentum balance into left_ and that of the rows into rows_, and returns the violation of the rows. It
  /// puts the sum of the magnitudes of the terms of the balance into size_, to which left_ is relative:
  /// momentum alone vanishes where a body turns back. `move` applies the correction: change_ of the motion
  /// and force_change_ of the constraint forces. The factors belong to one state, but the forces act along
  /// the gradients at the start of the step and the rows hold at its end. Anderson's method makes up for the
  /// difference; near a singular position the iteration would diverge without it. `most_left` [-] bounds the
  /// violation of a row that the factors leave out.
  template <class Look, class Move>
  void approach(System& system, const S& t, const S& most_left, const Look& look, const Move& move) {
    S before = std::numeric_limits<S>::max(), unbalanced(0);
    int still = 0;  // iterations in which the violation stood still
    Violation<S> rows;
    anderson_.clear();
    // A violation of rows that stands still while the momentum is balanced belongs to a row that the factors
    // leave out: near a singular position a row may be dependent at the start of the step and independent at
    // its end. Of positions 1e-6 is accepted, as in projection_iteration.hpp, of velocities a thousandth, for
    // a row that nothing enforces during the step misses them in proportion to h^3; the next step meets the
    // row. It stands still if it changes by less than a thousandth in each of three successive iterations;
    // these numbers are chosen by experiment. The iteration ends at 4 epsilon, or where a residual of
    // rounding size (up to 1024 epsilon, a safety factor) no longer halves. After the first corrections it
    // must fall every time, else the iteration diverges. The limits 5 and 50 of the corrections are chosen by
    // experiment.
    for (int k = 0; k < 50; ++k) {
      rows = look();
      unbalanced = size_ > S(0) ? S(left_.norm() / size_) : left_.norm();
      S now = rows.relative;
      raise(now, unbalanced);
      if (now <= rounding<S>() / 4 || (now <= 64 * rounding<S>() && !(now <= before / 2))) return;
      const bool stands = unbalanced <= 64 * rounding<S>() && rows.relative <= most_left && k > 0 &&
                          rows.relative > S(0.999) * before && rows.relative < S(1.001) * before;
      still = stands ? still + 1 : 0;
      if (still == 3) return;
      if (k > 5 && !stands && !(now <= before)) break;
      before = now;
      const Eigen::Index nv = none_.size(), nc = mu_.size();
      change_.setZero(nv);
      mu_change_.setZero(nc);
      system.reduce(factors_, left_, reduced_);
      rows_ = -rows_;
      system.solve(factors_, at_, reduced_, rows_, change_, mu_change_);
      changes_.resize(2 * nv + nc);
      changes_ << change_, momentum_of(system, change_) - left_, mu_change_;
      const StateVector<S>& step = anderson_.step(changes_, nv);
      change_ = step.head(nv);
      force_change_ = step.segment(nv, nv);
      mu_ += step.tail(nc);
      move();
      ++counters_.iterations;
    }
    const bool of_rows = rows.relative > unbalanced;
    throw IntegrationError({of_rows ? fmt::format("row \"{}\"", system.row_name(rows.row)) : std::string(),
                            static_cast<double>(t)},
                           fmt::format("the iteration of the step does not {}; take smaller steps",
                                       of_rows ? "satisfy this constraint row" : "balance the momentum"));
  }

  void factor(System& system) {
    system.factor(at_, {}, factors_);
    ++counters_.right_sides;
  }
  const StateVector<S>& momentum_of(System& system, const StateVector<S>& v) {
    system.inertia_force(at_, v, momentum_);
    return momentum_;
  }

  static constexpr double most_left_of_positions = 1e-6, most_left_of_velocities = 1e-3;

  const bool is_composed_;
  bool has_begun_ = false;
  typename System::Evaluation at_;
  typename System::Factors factors_;
  StateVector<S> mu_, rows_, reduced_, force_, momentum_, rate_, left_, none_, y_dot_;
  StateVector<S> change_, force_change_, mu_change_, changes_;  ///< within one iteration
  Anderson<S> anderson_;
  StateVector<S> from_, v_, theta_, known_, arriving_, off_;  ///< within one step
  S size_{0};
  Memory memory_;
  Counters counters_;
};

}  // namespace trivium::integrators
