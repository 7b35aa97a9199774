#pragma once
/// The generalised-alpha method on Lie groups: Arnold and Bruels, Multibody System Dynamics 18 (2007);
/// Bruels, Cardona and Arnold, Mechanism and Machine Theory 48 (2012).
///
///   dq = h v_n + h^2 ((1/2 - beta) a_n + beta a_n+1) + s,   q_n+1 = q_n o exp(dq)
///   v_n+1 = v_n + h ((1 - gamma) a_n + gamma a_n+1)
///   (1 - alpha_m) a_n+1 + alpha_m a_n = (1 - alpha_f) v'_n+1 + alpha_f v'_n
///   M v'_n+1 + Phi_q^T lambda_n+1 = Q
///
///   index 3:              Phi(q_n+1, t_n+1) = 0,  s = 0
///   stabilised index 2:   Phi(q_n+1, t_n+1) = 0,  Phi_q v_n+1 = nu,  M s + Phi_q^T eta = 0
///
/// s is the smallest shift that moves the positions onto their rows, and eta are its multipliers. In its
/// equation M and Phi_q are those of Newton's matrix, which includes the resistance of springs. The auxiliary
/// acceleration a approximates v' at t + (alpha_m - alpha_f) h to first order. Its initial value is this
/// approximation, so that order 2 holds from the first step on, also where M depends on q.

#include <optional>

#include "integrators/implicit/newton.hpp"
#include "integrators/initial_acceleration.hpp"
#include "integrators/linear_extrapolation.hpp"
#include "integrators/time_grid.hpp"
#include "integrators/work_quadrature.hpp"

namespace trivium::integrators {

/// Generalised-alpha of index 3 or of stabilised index 2. With given steps a model of the concept Method;
/// ErrorControl lets it choose its steps.
template <HasNewtonMatrix System>
requires HasInternalRows<System>
class GeneralizedAlpha {
 public:
  using S = typename System::Scalar;

  /// rho [-] in [0, 1] is the spectral radius at infinity: the factor by which a step damps the fastest
  /// oscillations.
  GeneralizedAlpha(double rho, bool is_stabilised, const NewtonOptions& newton)
      : is_stabilised_(is_stabilised),
        alpha_m_((2 * S(rho) - 1) / (S(rho) + 1)),
        alpha_f_(S(rho) / (S(rho) + 1)),
        gamma_(S(0.5) + alpha_f_ - alpha_m_),
        beta_((gamma_ + S(0.5)) * (gamma_ + S(0.5)) / 4),
        newton_(newton) {}

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
    // a_n approximates v' at t + (alpha_m - alpha_f) h with the last h; this h may be another one
    a_now_ = a_;
    reached = y;
    if (!is_same_length(h, *last_h_)) {
      const S ratio = h / *last_h_;
      system.accelerations(t, y, next_a_, x_.lambda);
      ++counters_.right_sides;
      a_now_ = next_a_ + ratio * (a_ - next_a_);
      if (!is_stabilised_) newton_.scale_velocity_violation(system, t, ratio * ratio, reached);
    }
    const S per_a = (1 - alpha_f_) / (1 - alpha_m_);
    const Shares<S> shares{h * h * beta_ * per_a, h * gamma_ * per_a};
    const int nq = system.position_size(), nv = system.velocity_size();
    v_ = reached.segment(nq, nv);
    known_ = (alpha_f_ * v_dot_.now() - alpha_m_ * a_now_) / (1 - alpha_m_);
    const auto place = [&](const StepUnknowns<S>& x, StateVector<S>& to) {
      next_a_ = known_ + per_a * x.v_dot;
      displacement_ = h * v_ + h * h * ((S(0.5) - beta_) * a_now_ + beta_ * next_a_);
      if (is_stabilised_) displacement_ += x.shift;
      system.displace(y, displacement_, to);
      to.segment(nq, nv) = v_ + h * ((1 - gamma_) * a_now_ + gamma_ * next_a_);
    };
    v_dot_.ahead(h / *last_h_, x_.v_dot);
    lambda_.ahead(h / *last_h_, x_.lambda);
    x_.shift.setZero(is_stabilised_ ? nv : 0);
    newton_(system, stop, shares, place, reached, x_, counters_);
  }
  /// Accepts the step of length h that was solved last, and adds its work to `reached`.
  void accept(System& system, const S& h, StateVector<S>& reached) {
    work_.add(system, newton_.at(), x_.lambda, h, reached);
    v_dot_.push(x_.v_dot);
    lambda_.push(x_.lambda);
    a_ = next_a_;
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
    v_dot_.begin(start.v_dot, start.v_ddot, h);
    lambda_.begin(start.lambda, start.lambda_dot, h);
    a_ = start.v_dot + (alpha_m_ - alpha_f_) * h * start.v_ddot;
    last_h_ = h;
    work_.begin(start.work_rate);
  }
  void show_memory(auto&& show) {
    v_dot_.show_memory(show);
    lambda_.show_memory(show);
    work_.show_memory(show);
    show(a_, *last_h_);
  }

 private:
  const bool is_stabilised_;
  const S alpha_m_, alpha_f_, gamma_, beta_;
  Newton<System> newton_;
  LinearExtrapolation<S> v_dot_, lambda_;
  StateVector<S> a_, a_now_, next_a_, displacement_, v_, known_, reached_;
  StepUnknowns<S> x_;
  WorkQuadrature<S> work_;
  std::optional<S> last_h_;
  Counters counters_;
};

}  // namespace trivium::integrators
