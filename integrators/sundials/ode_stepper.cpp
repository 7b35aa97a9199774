/// The right side and the error weights as functions that the library calls. `linear_system` factors only if
/// there are springs; `solve` applies the formulas of the header.

#include "integrators/sundials/ode_stepper.hpp"

namespace trivium::integrators::sundials_library {

int OdeStepper::right_side(double t, N_Vector numbers, N_Vector y_dot, void* stepper) {
  OdeStepper& self = of(stepper);
  return self.guarded([&] {
    ++self.counters_.right_sides;
    self.system().derivative(t, self.state(numbers), self.y_dot_);
    flat(y_dot) = self.y_dot_;
    return self.y_dot_.allFinite();
  });
}

int OdeStepper::error_weights(N_Vector numbers, N_Vector weights, void* stepper) {
  OdeStepper& self = of(stepper);
  const StateVectorD& y = self.state(numbers);
  self.weigh(y, self.tolerances_, flat(weights));
  // Newton's matrix has no terms for the work, which follows from q and v: the work must not count in error
  // estimates and convergence tests
  if (self.is_implicit_) {
    const auto motion = self.system().position_size() + self.system().velocity_size();
    flat(weights).tail(y.size() - motion).setConstant(no_weight);
  }
  return 0;
}

int OdeStepper::linear_system(double t, N_Vector numbers, N_Vector, SUNMatrix, int, int* is_current,
                              double gamma, void* stepper, N_Vector, N_Vector, N_Vector) {
  OdeStepper& self = of(stepper);
  *is_current = 1;
  return self.guarded([&] {
    AnySystem<double>& system = self.system();
    self.t_ = t;
    self.gamma_ = gamma;
    self.at_ = self.state(numbers);
    if (system.springs() > 0) {
      system.evaluate(t, self.at_, self.evaluated_);
      system.applied_force(self.evaluated_, self.force_);
      system.factor(self.evaluated_, {gamma * gamma, gamma}, self.factors_);
    }
    return true;
  });
}

void OdeStepper::solve(const Eigen::Map<StateVectorD>& b, Eigen::Map<StateVectorD> x) {
  AnySystem<double>& system = this->system();
  const int nq = system.position_size(), nv = system.velocity_size();
  b_v_ = b.segment(nq, nv);
  system.position_rate(at_, b_v_, rate_);
  x = b;
  x.head(nq) += gamma_ * rate_;
  if (system.springs() == 0) return;
  moved_ = at_;
  moved_.head(nq) += x.head(nq);
  moved_.segment(nq, nv) += b_v_;
  system.evaluate(t_, moved_, evaluated_);
  system.applied_force(evaluated_, moved_force_);
  system.reduce(factors_, moved_force_ - force_, left_);
  w_.setZero(nv);
  mu_.setZero(system.multipliers());
  no_rows_.setZero(system.multipliers());
  system.solve(factors_, evaluated_, left_, no_rows_, w_, mu_);
  x.segment(nq, nv) += gamma_ * w_;
  system.position_rate(at_, w_, rate_);
  x.head(nq) += gamma_ * gamma_ * rate_;
}

}  // namespace trivium::integrators::sundials_library
