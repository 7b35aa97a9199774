/// The Runge-Kutta methods of ARKODE, explicit and diagonally implicit.

#include <arkode/arkode_arkstep.h>

#include "integrators/sundials/methods.hpp"
#include "integrators/sundials/ode_stepper.hpp"

namespace trivium::integrators {

namespace sundials_library {

namespace {

const Functions arkode{.free = ARKStepFree,
                       .set_error_handler = ARKStepSetErrHandlerFn,
                       .set_user_data = ARKStepSetUserData,
                       .set_error_weights = ARKStepWFtolerances,
                       .set_linear_solver = ARKStepSetLinearSolver,
                       .set_nonlinear_solver = ARKStepSetNonlinearSolver,
                       .set_most_iterations = ARKStepSetMaxNonlinIters,
                       .set_first_step = ARKStepSetInitStep,
                       .set_stop = ARKStepSetStopTime,
                       .interpolate = ARKStepGetDky,
                       .planned_step = ARKStepGetCurrentStep,
                       .failed_errors = ARKStepGetNumErrTestFails,
                       .failed_solves = ARKStepGetNumStepSolveFails,
                       .iterations = ARKStepGetNumNonlinSolvIters};

/// Explicit or diagonally implicit Runge-Kutta methods of ARKODE. With given steps the tolerances only end
/// the iterations of the stages; 1e-13 is near rounding, so that the order of the method shows.
class Arkode final : public OdeStepper {
 public:
  Arkode(bool is_implicit, int order, const std::optional<Tolerances>& tolerances)
      : OdeStepper(arkode, tolerances.value_or(Tolerances{1e-13, 1e-13}), is_implicit),
        chooses_steps_(tolerances.has_value()),
        order_(order) {}

  bool shorten() override { return chooses_steps_ && Stepper::shorten(); }

 private:
  void begin(double t, const StateVectorD& y, double first_step) override {
    const ARKRhsFn explicit_part = is_implicit() ? nullptr : right_side,
                   implicit_part = is_implicit() ? right_side : nullptr;
    if (library_memory() == nullptr) {
      make_numbers(y.size());
      flat(numbers()) = y;
      open(ARKStepCreate(explicit_part, implicit_part, t, numbers(), context()));
      choose_method();
    } else {
      flat(numbers()) = y;
      accept(ARKStepReInit(library_memory(), explicit_part, implicit_part, t, numbers()), "restart");
    }
    if (chooses_steps_) begin_with(first_step);
  }
  void choose_method() {
    measure_errors_by(error_weights);
    accept(ARKStepSetMaxHnilWarns(library_memory(), -1), "suppress warnings");
    accept(ARKStepSetOrder(library_memory(), order_), "set the order");
    if (!is_implicit()) return;
    iterate_by_newton();
    // A matrix of another step size leaves an error of the stages in proportion to the change of the size.
    // The library's test does not see it: it takes the iteration for as fast as with earlier matrices.
    accept(ARKStepSetDeltaGammaMax(library_memory(), 1e-10), "set when a new matrix is needed");
    accept(ARKStepSetLinSysFn(library_memory(), step_matrix), "set the matrix");
  }
  /// ARKODE also passes a mass matrix here; y' = f(t, y) has none.
  static int step_matrix(double t, N_Vector numbers, N_Vector f, SUNMatrix matrix, SUNMatrix, int is_kept,
                         int* is_current, double gamma, void* stepper, N_Vector a, N_Vector b, N_Vector c) {
    return linear_system(t, numbers, f, matrix, is_kept, is_current, gamma, stepper, a, b, c);
  }
  int advance(double stop, double& t) override {
    if (!chooses_steps_) accept(ARKStepSetFixedStep(library_memory(), stop - t), "set the fixed step");
    return ARKStepEvolve(library_memory(), stop, numbers(), &t, ARK_ONE_STEP);
  }
  /// With given steps the library starts anew in every step, so that a saved run continues exactly.
  bool keeps_nothing() const override { return !chooses_steps_; }
  double planned() const override { return chooses_steps_ ? Stepper::planned() : 0; }

  const bool chooses_steps_;
  const int order_;
};

}  // namespace

}  // namespace sundials_library

DoubleMethod make_arkode(bool is_implicit, int order, const std::optional<Tolerances>& tolerances) {
  return std::make_unique<sundials_library::Arkode>(is_implicit, order, tolerances);
}

}  // namespace trivium::integrators
