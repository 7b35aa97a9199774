/// The Adams methods and BDF of CVODE.

#include <cvode/cvode.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "integrators/projection_iteration.hpp"
#include "integrators/sundials/methods.hpp"
#include "integrators/sundials/ode_stepper.hpp"

namespace trivium::integrators {

namespace sundials_library {

namespace {

const Functions cvode{.free = CVodeFree,
                      .set_error_handler = CVodeSetErrHandlerFn,
                      .set_user_data = CVodeSetUserData,
                      .set_error_weights = CVodeWFtolerances,
                      .set_linear_solver = CVodeSetLinearSolver,
                      .set_nonlinear_solver = CVodeSetNonlinearSolver,
                      .set_most_iterations = CVodeSetMaxNonlinIters,
                      .set_first_step = CVodeSetInitStep,
                      .set_stop = CVodeSetStopTime,
                      .interpolate = CVodeGetDky,
                      .planned_step = CVodeGetCurrentStep,
                      .failed_errors = CVodeGetNumErrTestFails,
                      .failed_solves = CVodeGetNumStepSolveFails,
                      .iterations = CVodeGetNumNonlinSolvIters};

/// Adams methods and BDF of CVODE; BDF with projection if it `projects`.
class Cvode final : public OdeStepper {
 public:
  enum class Formula { adams, backward };

  Cvode(Formula formula, const Tolerances& tolerances, bool projects)
      : OdeStepper(cvode, tolerances, formula == Formula::backward), projects_(projects) {}

  bool interpolates() const override { return true; }

 private:
  void begin(double t, const StateVectorD& y, double first_step) override {
    if (library_memory() == nullptr) {
      make(t, y);
    } else {
      flat(numbers()) = y;
      accept(CVodeReInit(library_memory(), t, numbers()), "restart");
    }
    begin_with(first_step);
  }
  void make(double t, const StateVectorD& y) {
    make_numbers(y.size());
    flat(numbers()) = y;
    open(CVodeCreate(is_implicit() ? CV_BDF : CV_ADAMS, context()));
    accept(CVodeInit(library_memory(), right_side, t, numbers()), "set the initial state");
    measure_errors_by(error_weights);
    accept(CVodeSetMaxHnilWarns(library_memory(), -1), "suppress warnings");
    if (!is_implicit()) return iterate_by(own(SUNNonlinSol_FixedPoint(numbers(), 0, context())));
    iterate_by_newton();
    accept(CVodeSetLinSysFn(library_memory(), linear_system), "set the matrix");
    // A small error of the positions along a stiff spring is a large error of its force, which the error
    // estimates of later steps show. The tolerance of Newton's method is therefore a tenth of the default.
    if (system().springs() > 0)
      accept(CVodeSetNonlinConvCoef(library_memory(), 0.01), "set the tolerance of Newton's method");
    if (!projects_) return;
    accept(CVodeSetProjFn(library_memory(), project), "set the projection");
    // With a projected error estimate steps would be longer by a tenth and errors ten times as large.
    accept(CVodeSetProjErrEst(library_memory(), 0), "leave the projection out of the error estimate");
  }
  int advance(double stop, double& t) override {
    return CVode(library_memory(), stop, numbers(), &t, CV_ONE_STEP);
  }

  /// Called by CVODE: `change` is the correction that leads back onto the constraints.
  static int project(double t, N_Vector numbers, N_Vector change, double, N_Vector /*error*/, void* stepper) {
    Cvode& self = static_cast<Cvode&>(*static_cast<Stepper*>(stepper));
    return self.guarded([&] {
      StateVectorD projected = self.state(numbers);
      const StateVectorD before = projected;
      ProjectionReport<double> report;
      self.projection_(self.system(), t, projected, report);
      flat(change) = projected - before;
      return true;
    });
  }

  const bool projects_;
  ProjectionIteration<AnySystem<double>> projection_;
};

}  // namespace

}  // namespace sundials_library

DoubleMethod make_cvode_adams(const Tolerances& tolerances) {
  using sundials_library::Cvode;
  return std::make_unique<Cvode>(Cvode::Formula::adams, tolerances, false);
}

DoubleMethod make_cvode_bdf(const Tolerances& tolerances, bool projects) {
  using sundials_library::Cvode;
  return std::make_unique<Cvode>(Cvode::Formula::backward, tolerances, projects);
}

}  // namespace trivium::integrators
