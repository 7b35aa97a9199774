#include <arkode/arkode_arkstep.h>

#include "integrators/sundials.hpp"
#include "integrators/sundials/newton.hpp"
#include "integrators/sundials/ode_stepper.hpp"

namespace trivium::integrators {

namespace sundials_library {

namespace {

class Arkode final : public OdeStepper {
 public:
  Arkode(bool is_implicit, int order, const std::optional<Tolerances>& tolerances)
      : OdeStepper(tolerances.value_or(Tolerances{1e-13, 1e-13}), is_implicit),
        chooses_steps_(tolerances.has_value()),
        order_(order) {}
  ~Arkode() override { ARKStepFree(&memory_); }
  Arkode(const Arkode&) = delete;
  Arkode& operator=(const Arkode&) = delete;

  bool shorten() override { return chooses_steps_ && Stepper::shorten(); }

 private:
  void begin(double t, const FlatD& y, double first_step) override {
    if (memory_ == nullptr) {
      make(t, y);
    } else {
      flat(numbers()) = y;
      accept(ARKStepReInit(memory_, is_implicit() ? nullptr : right_side,
                           is_implicit() ? right_side : nullptr, t, numbers()),
             "to begin again");
    }
    t_ = t;
    if (chooses_steps_) accept(ARKStepSetInitStep(memory_, first_step), "a first step");
  }
  void make(double t, const FlatD& y) {
    make_numbers(y.size());
    flat(numbers()) = y;
    memory_ = ARKStepCreate(is_implicit() ? nullptr : right_side, is_implicit() ? right_side : nullptr, t,
                            numbers(), context());
    accept(ARKStepSetErrHandlerFn(memory_, note_error, static_cast<Stepper*>(this)), "to report its errors");
    accept(ARKStepSetUserData(memory_, static_cast<OdeStepper*>(this)), "its system");
    accept(ARKStepWFtolerances(memory_, error_weights), "its tolerances");
    accept(ARKStepSetMaxHnilWarns(memory_, -1), "to be silent");
    accept(ARKStepSetOrder(memory_, order_), "its order");
    if (!is_implicit()) return;
    linear_solver_ = make_linear_solver();
    matrix_ = make_matrix();
    accept(ARKStepSetLinearSolver(memory_, linear_solver_.get(), matrix_.get()), "its linear solver");
    accept(ARKStepSetLinSysFn(memory_, step_matrix), "its matrix");
    newton_ = make_accelerated_newton(context());
    accept(ARKStepSetNonlinearSolver(memory_, newton_.get()), "its Newton's method");
    accept(ARKStepSetMaxNonlinIters(memory_, most_iterations), "how long it iterates");
  }
  /// Without a mass matrix, which y' has none of.
  static int step_matrix(double t, N_Vector numbers, N_Vector f, SUNMatrix matrix, SUNMatrix, int is_kept,
                         int* is_current, double gamma, void* stepper, N_Vector a, N_Vector b, N_Vector c) {
    return linear_system(t, numbers, f, matrix, is_kept, is_current, gamma, stepper, a, b, c);
  }
  int advance(double stop, double& t) override {
    if (!chooses_steps_) accept(ARKStepSetFixedStep(memory_, stop - t_), "a step");
    accept(ARKStepSetStopTime(memory_, stop), "where to stop");
    const int flag = ARKStepEvolve(memory_, stop, numbers(), &t, ARK_ONE_STEP);
    t_ = t;
    return flag;
  }
  double planned() const override {
    double h = 0;
    if (chooses_steps_) ARKStepGetCurrentStep(memory_, &h);
    return h;
  }
  Progress progress() const override {
    long errors = 0, failures = 0, iterations = 0;
    ARKStepGetNumErrTestFails(memory_, &errors);
    if (is_implicit()) {
      ARKStepGetNumStepSolveFails(memory_, &failures);
      ARKStepGetNumNonlinSolvIters(memory_, &iterations);
    }
    return {errors + failures, iterations};
  }

  const bool chooses_steps_;
  const int order_;
  void* memory_ = nullptr;
  double t_ = 0;
  Owned<SUNLinearSolver> linear_solver_;
  Owned<SUNMatrix> matrix_;
  Owned<SUNNonlinearSolver> newton_;
};

}  // namespace

}  // namespace sundials_library

DoubleMethod make_arkode(bool is_implicit, int order, const std::optional<Tolerances>& tolerances) {
  return std::make_unique<sundials_library::Arkode>(is_implicit, order, tolerances);
}

}  // namespace trivium::integrators
