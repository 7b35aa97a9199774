#pragma once
/// RATTLE on a Lie group: the variational integrator of the discrete Lagrangian h (1/2 Omega^T M Omega - V),
/// with q_n+1 = q_n o exp(theta), theta = h Omega, and constraints on positions and velocities. Symplectic
/// where forces have a potential, of order 2. Hairer, Lubich and Wanner, Geometric Numerical Integration
/// (2006), VII.1 and VII.5; Lee, Leok and McClamroch, Computer Methods in Applied Mechanics and Engineering
/// 196 (2007).
///
///   T(theta)^-1 M theta / h = M v_n + h/2 (f_n - Phi_q^T lambda_n),      Phi(q_n+1, t_n+1) = 0
///   M v_n+1 = T(-theta)^-1 M theta / h + h/2 (f_n+1 - Phi_q^T mu_n+1),    Phi_q v_n+1 = nu
///
/// T is that of displacement_rate, and f what effects do: gyroscopic terms are in T. Composed of five
/// (Suzuki, Physics Letters A 146 (1990)) it has order 4; no part of such a step leaves it, so that it sees
/// nothing of what is beyond an event. Its own multipliers are mu_n+1, less what mu_n and lambda_n tell of
/// its error: of order 2. Work is that of the states between, by trapezoids: of the method's order.

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "integrators/contract/errors.hpp"
#include "integrators/contract/newton_matrix.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/initial_acceleration.hpp"
#include "integrators/work_quadrature.hpp"

namespace trivium::integrators {

template <HasNewtonMatrix System>
class Rattle {
 public:
  using S = typename System::Scalar;

  /// Of order 2 or 4.
  explicit Rattle(int order) : is_composed_(order == 4) {}

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    using std::pow;
    if (!system.inertia_is_constant())
      throw UsageError("rattle needs coordinates in which the mass matrix does not depend on positions");
    const S h = stop - t;
    if (!has_begun_) begin(system, t, y, stop);
    if (is_composed_) {
      const S part = 1 / (4 - pow(S(4), S(1) / 3)) * h, back = h - 4 * part;
      advance(system, t, S(t + part), y);
      advance(system, S(t + part), S(t + 2 * part), y);
      advance(system, S(t + 2 * part), S(t + 2 * part + back), y);
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
  const StateVector<S>* lambda() const { return has_begun_ ? &lambda_ : nullptr; }

  bool has_begun() const { return has_begun_; }
  void begin(System& system, const S& t, const StateVector<S>& y, const S& stop) {
    const InitialAcceleration<S> start(system, t, y, stop - t, counters_);
    none_.setZero(system.velocity_size());
    lambda_ = last_mu_ = start.lambda;
    last_h_ = S(0);
    // what constraints do: what does not balance with their multipliers, less what does not without
    system.evaluate(t, y, at_);
    system.residual(at_, none_, lambda_, held_);
    system.residual(at_, none_, StateVector<S>::Zero(system.multipliers()), left_);
    held_ -= left_;
    factor(system);
    work_.begin(start.work_rate);
    has_begun_ = true;
  }
  void show_memory(auto&& show) {
    work_.show_memory(show);
    show(held_, lambda_, last_h_);
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
    known_ = h * momentum_ + h * h / 2 * (force_ + held_);
    theta_ = h * v_;
    mu_.setZero(system.multipliers());
    approach(
        system, t_next, known_,
        [&] {
          system.displace(from_, theta_, y);
          system.evaluate(t_next, y, at_);
          system.inertia_force(at_, theta_, momentum_);
          system.displacement_rate(theta_, momentum_, rate_);
          left_ = known_ - rate_;
          return system.position_rows(at_, rows_);
        },
        [&] {
          theta_ += change_;
          known_ += momentum_of(system, change_) - left_;  // by what constraints do
        });
    // lambda_n and mu_n are off by as much to either side, in proportion to the step after and before
    off_ = h / (h + last_h_) * 2 / (h * h) * mu_;
    system.inertia_force(at_, theta_, momentum_);
    y.segment(nq, nv) = theta_ / h;
    theta_ = -theta_;
    system.displacement_rate(theta_, momentum_, rate_);
    arriving_ = rate_ / h;
    system.evaluate(t_next, y, at_);
    factor(system);
    held_.setZero(nv);
    mu_.setZero();
    approach(
        system, t_next, arriving_,
        [&] {
          system.evaluate(t_next, y, at_);
          system.applied_force(at_, force_);
          v_ = y.segment(nq, nv);
          left_ = arriving_ + h / 2 * (force_ + held_) - momentum_of(system, v_);
          return system.velocity_rows(at_, rows_);
        },
        [&] {
          y.segment(nq, nv) += change_;
          held_ += 2 / h * (momentum_of(system, change_) - left_);
        });
    last_mu_ = 2 / h * mu_;
    last_h_ = h;
    lambda_ = last_mu_ + off_;
    if (y.size() == nq + nv) return;
    system.derivative(t_next, y, y_dot_);
    ++counters_.right_sides;
    work_.add(y_dot_[nq + nv], h, y[nq + nv]);
  }

  /// To rounding, by the factors made last: `look` leaves what does not balance in left_, what the rows miss
  /// in rows_, and returns their violation; `move` takes what would mend both from change_.
  template <class Look, class Move>
  void approach(System& system, const S& t, const StateVector<S>& beside, const Look& look,
                const Move& move) {
    S before = std::numeric_limits<S>::max();
    Violation<S> rows;
    for (int k = 0; k < 50; ++k) {
      rows = look();
      const S size = beside.norm();
      const S unbalanced = size > S(0) ? S(left_.norm() / size) : left_.norm();
      S now = rows.relative;
      raise(now, unbalanced);
      if (now <= rounding<S>() / 4 || (now <= 64 * rounding<S>() && !(now <= before / 2))) return;
      if (k > 5 && !(now <= before)) break;
      before = now;
      change_.setZero(none_.size());
      system.reduce(factors_, left_, reduced_);
      rows_ = -rows_;
      system.solve(factors_, at_, reduced_, rows_, change_, mu_);
      move();
      ++counters_.iterations;
    }
    throw IntegrationError({fmt::format("row \"{}\"", system.row_name(rows.row)), static_cast<double>(t)},
                           "the step does not meet it; take smaller steps");
  }

  void factor(System& system) {
    system.factor(at_, {}, factors_);
    ++counters_.right_sides;
  }
  const StateVector<S>& momentum_of(System& system, const StateVector<S>& v) {
    system.inertia_force(at_, v, momentum_);
    return momentum_;
  }

  const bool is_composed_;
  bool has_begun_ = false;
  typename System::Evaluation at_;
  typename System::Factors factors_;
  StateVector<S> lambda_, mu_, rows_, reduced_, force_, momentum_, rate_, left_, change_, none_, y_dot_;
  StateVector<S> from_, v_, theta_, known_, arriving_, off_;  ///< of a step
  StateVector<S> held_, last_mu_;                             ///< what constraints do at the last state
  S last_h_{0};
  WorkQuadrature<S> work_;
  Counters counters_;
};

}  // namespace trivium::integrators
