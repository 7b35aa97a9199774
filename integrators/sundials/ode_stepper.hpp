#pragma once
/// The common part of CVODE and ARKODE, the SUNDIALS integrators of y' = f(t, y): the right side, the error
/// weights, and the linear systems with Newton's matrix I - gamma f_y. The system solves these with its own
/// factors instead of a matrix of SUNDIALS.

#include "integrators/sundials/stepper.hpp"

namespace trivium::integrators::sundials_library {

/// The approximation of f_y contains the resistance of springs and dampers along their own directions, and
/// the motion of q with v. gamma [s] is the library's factor, a share of the step. The solution x for the
/// right side b is
///
///   (M + gamma C + gamma^2 K) w + Phi_q^T mu = Q(q + b_q + gamma b_v, v + b_v) - Q(q, v),   Phi_q w = 0
///
///   x_v = b_v + gamma w,   x_q = b_q + gamma x_v
///
/// The terms left out (gyroscopic and geometric) are of the order of the angle by which bodies rotate in a
/// step.
class OdeStepper : public Stepper {
 public:
  // callbacks of the library; their user data is the stepper
  static int right_side(double t, N_Vector numbers, N_Vector y_dot, void* stepper);
  static int error_weights(N_Vector numbers, N_Vector weights, void* stepper);
  static int linear_system(double t, N_Vector numbers, N_Vector f, SUNMatrix, int is_kept, int* is_current,
                           double gamma, void* stepper, N_Vector, N_Vector, N_Vector);

 protected:
  OdeStepper(const Functions& functions, const Tolerances& tolerances, bool is_implicit)
      : Stepper(functions), tolerances_(tolerances), is_implicit_(is_implicit) {}
  bool is_implicit() const { return is_implicit_; }
  void solve(const Eigen::Map<StateVectorD>& b, Eigen::Map<StateVectorD> x) override;

 private:
  static OdeStepper& of(void* stepper) { return static_cast<OdeStepper&>(*static_cast<Stepper*>(stepper)); }

  Tolerances tolerances_;
  const bool is_implicit_;
  double t_ = 0, gamma_ = 0;
  StateVectorD at_, force_;  ///< state about which f was linearised, and Q there
  AnyEvaluation evaluated_;
  AnyFactors factors_;
  StateVectorD y_dot_, b_v_, rate_, moved_, moved_force_, left_, w_, mu_, no_rows_;
};

}  // namespace trivium::integrators::sundials_library
