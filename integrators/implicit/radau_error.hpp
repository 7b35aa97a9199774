#pragma once
/// Norms of Radau's corrections and of its estimated error, in units of the tolerances. Hairer and Wanner,
/// Solving Ordinary Differential Equations II (1996), IV.8.

#include "base/raise.hpp"
#include "integrators/error_norm.hpp"
#include "integrators/implicit/radau_stages.hpp"

namespace trivium::integrators {

/// The norms for steps of s stages. Radau ends an iteration by `of_correction`; take_chosen_step accepts or
/// rejects a step by `of_step`.
template <HasSprings System, int s>
requires HasInternalRows<System>
class RadauError {
 public:
  using S = typename System::Scalar;
  using Stages = RadauStages<System, s>;

  explicit RadauError(const Tolerances& tolerances) : tolerances_(tolerances) {}
  const Tolerances& tolerances() const { return tolerances_; }

  /// Prepares for steps from (t, y).
  void begin(System& system, const S& t, const StateVector<S>& y) {
    system.position_sizes(y, sizes_);
    system.evaluate(t, y, at_start_);
  }

  /// Size of a correction [tolerances]: the largest change of a stage's position and velocity.
  S of_correction(const Stages& stages, const StateVector<S>& step, const S& h, const StateVector<S>& y) {
    const auto& coefficients = stages.coefficients();
    const int nv = stages.nv(), nc = stages.nc();
    const auto of_v_dot = [&](int j) { return step.segment(j * nv, nv); };
    const auto of_shift = [&](int j) { return step.segment(s * (nv + nc) + j * nv, nv); };
    S largest(0);
    for (int i = 0; i < s; ++i) {
      of_v_ = h * Stages::mix(coefficients.a[i], of_v_dot);
      of_q_ = h * h * Stages::mix(coefficients.square[i], of_v_dot) +
              h * Stages::mix(coefficients.a[i], of_shift);
      raise(largest, in_tolerances(stages, y, of_q_, of_v_));
    }
    return largest;
  }

  /// Estimated error [tolerances] of the step from y, of order s. Newton's matrix filters its velocities:
  /// errors that stiff springs would damp, or that the constraints do not admit, do not count.
  S of_step(System& system, const Stages& stages, const S& h, const StateVector<S>& y) {
    const auto& coefficients = stages.coefficients();
    const auto v = y.segment(stages.nq(), stages.nv());
    const auto& e = coefficients.error;
    const S& gamma = coefficients.gamma;
    off_v_ = gamma * h * stages.known().v_dot;
    for (int i = 0; i < s; ++i) off_v_ += e[i] * (stages[i].v - v);
    of_q_ = gamma * h * v + stages.mixed(e, &Stages::Stage::theta);
    const auto& last = stages.last();
    system.inertia_force(at_start_, off_v_, force_);
    system.reduce(last.factors, force_, left_);
    of_v_.setZero(stages.nv());
    mu_.setZero(stages.nc());
    no_rows_.setZero(stages.nc());
    system.solve(last.factors, last.at, left_, no_rows_, of_v_, mu_);
    return in_tolerances(stages, y, of_q_, of_v_);
  }

 private:
  S in_tolerances(const Stages& stages, const StateVector<S>& y, const StateVector<S>& of_q,
                  const StateVector<S>& of_v) const {
    return integrators::in_tolerances<S>(tolerances_, sizes_, y.segment(stages.nq(), stages.nv()),
                                         stages.last().v, of_q, of_v);
  }

  Tolerances tolerances_;
  StateVector<S> sizes_;  ///< sizes that a displacement's relative errors refer to
  typename System::Evaluation at_start_;
  StateVector<S> of_q_, of_v_, off_v_, force_, left_, mu_, no_rows_;
};

}  // namespace trivium::integrators
