#pragma once
/// The method of Hilber, Hughes and Taylor for index 3 (HHT-I3): Negrut, Rampalli, Ottarsson and Sajdak,
/// Journal of Computational and Nonlinear Dynamics 2 (2007). It has Newmark's formulas with gamma = 1/2 -
/// alpha, beta = (1 - alpha)^2 / 4, alpha in [-1/3, 0], and the equations
///
///   M (a_n+1 / (1 + alpha) + alpha / (1 + alpha) v'_n) + g_n+1 = 0,   g = Phi_q^T lambda - Q
///   Phi(q_n+1, t_n+1) = 0
///
/// where v'_n is the acceleration of the last step's balance, M v'_n = -g_n. The paper writes -g_n in place
/// of M v'_n, which is the same for a constant M. Where M depends on q, as in r-p and r-epsilon, M(q_n+1)^-1
/// g_n differs from M(q_n)^-1 g_n by a term of order h, and the order would fall to 1.

#include <optional>

#include "integrators/implicit/newton.hpp"
#include "integrators/initial_acceleration.hpp"
#include "integrators/linear_extrapolation.hpp"
#include "integrators/time_grid.hpp"
#include "integrators/work_quadrature.hpp"

namespace trivium::integrators {

/// HHT-I3 with one alpha. With given steps a model of the concept Method; ErrorControl lets it choose its
/// steps.
template <HasNewtonMatrix System>
requires HasInternalRows<System>
class HHT {
 public:
  using S = typename System::Scalar;

  HHT(double alpha, const NewtonOptions& newton)
      : alpha_(alpha), gamma_(S(0.5) - alpha_), beta_((1 - alpha_) * (1 - alpha_) / 4), newton_(newton) {}

  void step(System& system, S& t, StateVector<S>& y, const S& stop) {
    attempt(system, t, stop, y, reached_);
    accept(system, stop - t, reached_);
    y.swap(reached_);
    t = stop;
  }
  /// Solves a step from (t, y) to `stop`, whose end is `reached`. Nothing is remembered before `accept`.
  void attempt(System& system, const S& t, const S& stop, const StateVector<S>& y, StateVector<S>& reached) {
    const S h = stop - t;
    if (!last_h_) begin(system, t, y, stop);
    const int nq = system.position_size(), nv = system.velocity_size();
    reached = y;
    // a_n approximates v' at t + alpha h with the last h; this h may be another one
    a_now_ = a_.now();
    if (!is_same_length(h, *last_h_)) {
      const S ratio = h / *last_h_;
      system.accelerations(t, y, v_dot_, x_.lambda);
      ++counters_.right_sides;
      a_now_ = v_dot_ + ratio * (a_.now() - v_dot_);
      newton_.scale_velocity_violation(system, t, ratio * ratio, reached);
    }
    v_ = reached.segment(nq, nv);
    // Newton's unknown is v'_n+1, so that its factor in the equations is M
    const S per_x = 1 + alpha_;
    const auto place = [&](const StepUnknowns<S>& x, StateVector<S>& to) {
      a_next_ = per_x * x.v_dot - alpha_ * v_dot_now_;
      displacement_ = h * v_ + h * h * ((S(0.5) - beta_) * a_now_ + beta_ * a_next_);
      system.displace(y, displacement_, to);
      to.segment(nq, nv) = v_ + h * ((1 - gamma_) * a_now_ + gamma_ * a_next_);
    };
    a_.ahead(h / *last_h_, x_.v_dot);
    x_.v_dot = (x_.v_dot + alpha_ * v_dot_now_) / per_x;
    lambda_.ahead(h / *last_h_, x_.lambda);
    newton_(system, stop, {h * h * beta_ * per_x, h * gamma_ * per_x}, place, reached, x_, counters_);
  }
  /// Accepts the step of length h that was solved last, and adds its work to `reached`.
  void accept(System& system, const S& h, StateVector<S>& reached) {
    work_.add(system, newton_.at(), x_.lambda, h, reached);
    a_.push(a_next_);  // placed last
    v_dot_now_ = x_.v_dot;
    lambda_.push(x_.lambda);
    last_h_ = h;
    ++counters_.steps;
  }
  /// Newton::filter with the matrix of the step that was solved last.
  void filter(System& system, StateVector<S>& change) { newton_.filter(system, change); }
  void restart() {
    last_h_.reset();
    ++counters_.restarts;
  }
  bool shorten() { return false; }
  const Counters& counters() const { return counters_; }
  const StateVector<S>* lambda() const { return last_h_ ? &lambda_.now() : nullptr; }

  bool has_begun() const { return last_h_.has_value(); }
  void begin(System& system, const S& t, const StateVector<S>& y, const S& stop) {
    const S h = stop - t;
    const InitialAcceleration<S> start(system, t, y, h, counters_);
    a_.begin(start.v_dot, start.v_ddot, h);
    lambda_.begin(start.lambda, start.lambda_dot, h);
    v_dot_now_ = start.v_dot;
    last_h_ = h;
    work_.begin(start.work_rate);
  }
  void show_memory(auto&& show) {
    a_.show_memory(show);
    lambda_.show_memory(show);
    work_.show_memory(show);
    show(v_dot_now_, *last_h_);
  }

 private:
  const S alpha_, gamma_, beta_;
  Newton<System> newton_;
  LinearExtrapolation<S> a_, lambda_;
  StateVector<S> v_dot_now_;  ///< v'_n
  StateVector<S> a_now_, a_next_, v_dot_, displacement_, v_, reached_;
  StepUnknowns<S> x_;
  WorkQuadrature<S> work_;
  std::optional<S> last_h_;
  Counters counters_;
};

}  // namespace trivium::integrators
