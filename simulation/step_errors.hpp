#pragma once
/// The errors that the given steps of a run commit: by formulas over past states for methods of the orders 1
/// to 5 (system/local_error.hpp), by halved steps above (halved_step_errors.hpp).

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "integrators/contract/any_method.hpp"
#include "mechanism/reach.hpp"
#include "simulation/halved_step_errors.hpp"
#include "simulation/system/constrained_equations.hpp"
#include "simulation/system/local_error.hpp"

namespace trivium {

/// Follows the accepted states of a run and sums the errors of its steps.
template <Formulation F>
class StepErrors {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;

  /// `order` of the method; `on_displacements`: it works on displacements. `halved` takes steps in halves by
  /// the same method. The equations and the method must outlive this object.
  StepErrors(ConstrainedEquations<F>& constrained, const integrators::AnyMethod<S>& method, int order,
             bool on_displacements, HalvedSteps<S> halved)
      : equations_(constrained.first_order()), method_(method) {
    std::vector<int> component;
    for (int b = 0; b < equations_.nb(); ++b) component.push_back(equations_.measure().component_of(b));
    std::vector<S> reach = reaches(equations_.mechanism());
    if (order <= LocalError<S>::highest_order)
      by_formula_.emplace(order, std::move(reach), std::move(component));
    else
      by_halves_.emplace(constrained, method, order, on_displacements, std::move(halved),
                         ErrorSums<S>(std::move(reach), std::move(component)));
  }

  /// Adds the start, a step that ended at an accepted state, or an event after which the motion begins anew.
  /// `off` is the violation of velocities there.
  void step(const S& t, const StateVector& y, const integrators::Violation<S>& off) {
    if (has_begun_ && t == t_) return;  // an output at the end of a step
    const bool is_start = !std::exchange(has_begun_, true);
    if (is_start) start_ = t;
    const bool begins = std::exchange(events_, equations_.events()) < equations_.events() || is_start;
    const bool has_restarted =
        std::exchange(restarts_, method_.counters().restarts) < method_.counters().restarts;
    const S before = std::exchange(t_, t);
    if (by_halves_) {
      bodies_at(equations_, t, y, reached_);
      if (begins)
        by_halves_->begin(t, y, reached_);
      else
        by_halves_->step(before, t, y, has_restarted, reached_);
    } else if (begins) {
      bodies_at(equations_, t, y, reached_);
      by_formula_->begin(reached_);
    } else if (!by_formula_->leaves_out()) {
      add_state(t, y, S(t - before), off);
    }
  }

  LocalErrorSums sums() {
    std::vector<double> least;  // the speed that loads could give
    for (int b = 0; b < equations_.nb(); ++b)
      least.push_back(static_cast<double>(equations_.measure().fastest_of(b)));
    add_roundings(least);
    return by_halves_ ? by_halves_->sums(least) : by_formula_->sums(least);
  }

 private:
  /// Where loads cancel, such as gravity and springs, what they could give is nothing, but rounding errors
  /// u F / m of accelerations remain. Speeds that add up from them are no motion either.
  void add_roundings(std::vector<double>& least) const {
    constexpr double roundings = 1000;  // of the formulas, of all steps in the same direction
    const double u_t = roundings * static_cast<double>(std::numeric_limits<S>::epsilon() * S(t_ - start_));
    const std::vector<Wrench<S>> sizes = equations_.load_sizes(t_);
    const std::vector<S> reach = reaches(equations_.mechanism());
    for (std::size_t b = 0; b < least.size(); ++b) {
      const S& mass = equations_.mechanism().bodies[b].mass;
      if (!(mass > S(0))) continue;
      const S of_moments = reach[b] > S(0) ? S(sizes[b].n_bar.norm() / reach[b]) : S(0);
      raise(least[b], u_t * static_cast<double>(S((sizes[b].F.norm() + of_moments) / mass)));
    }
  }
  /// With index 3 the violation of velocities is of order h^2 and does not accumulate; the velocities are
  /// projected, so that only errors count that do.
  void add_state(const S& t, const StateVector& y, const S& h, const integrators::Violation<S>& off) {
    const bool is_off = off.relative > 1000 * std::numeric_limits<S>::epsilon();
    if (is_off) {
      met_ = y;
      equations_.correct_velocities(t, met_, false);
    }
    bodies_at(equations_, t, y, reached_);
    for (int b = 0; is_off && b < equations_.nb(); ++b) {
      BodyState<F> state = equations_.state()[b];
      const auto& layout = equations_.layout();
      state.q = F::from_orientation(state.chart, layout.orientation(met_, b), layout.velocity(met_, b));
      reached_[b].v = layout.rate(met_, b).template head<3>();
      reached_[b].omega_bar = kinematics_of(state).omega_bar;
    }
    by_formula_->add(reached_, h, is_off);
  }

  FirstOrderEquations<F>& equations_;
  const integrators::AnyMethod<S>& method_;
  std::optional<LocalError<S>> by_formula_;
  std::optional<HalvedStepErrors<F>> by_halves_;
  std::vector<BodyInMotion<S>> reached_;
  StateVector met_;    ///< the state with projected velocities
  S start_{0}, t_{0};  ///< of the run, of the last state [s]
  long events_ = 0, restarts_ = 0;
  bool has_begun_ = false;
};

}  // namespace trivium
