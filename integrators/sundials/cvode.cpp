#include <cvode/cvode.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "integrators/projection.hpp"
#include "integrators/sundials.hpp"
#include "integrators/sundials/newton.hpp"
#include "integrators/sundials/ode_stepper.hpp"

namespace trivium::integrators {

namespace sundials_library {

namespace {

class Cvode final : public OdeStepper {
 public:
  enum class Formula { adams, backward };

  Cvode(Formula formula, const Tolerances& tolerances, bool projects)
      : OdeStepper(tolerances, formula == Formula::backward), projects_(projects) {}
  ~Cvode() override { CVodeFree(&memory_); }
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;

  bool interpolates() const override { return true; }

 private:
  void begin(double t, const FlatD& y, double first_step) override {
    if (memory_ == nullptr) {
      make(t, y);
    } else {
      flat(numbers()) = y;
      accept(CVodeReInit(memory_, t, numbers()), "to begin again");
    }
    accept(CVodeSetInitStep(memory_, first_step), "a first step");
  }
  void make(double t, const FlatD& y) {
    make_numbers(y.size());
    flat(numbers()) = y;
    memory_ = CVodeCreate(is_implicit() ? CV_BDF : CV_ADAMS, context());
    accept(CVodeSetErrHandlerFn(memory_, note_error, static_cast<Stepper*>(this)), "to report its errors");
    accept(CVodeInit(memory_, right_side, t, numbers()), "its state");
    accept(CVodeSetUserData(memory_, static_cast<OdeStepper*>(this)), "its system");
    accept(CVodeWFtolerances(memory_, error_weights), "its tolerances");
    accept(CVodeSetMaxHnilWarns(memory_, -1), "to be silent");
    if (is_implicit()) {
      linear_solver_ = make_linear_solver();
      matrix_ = make_matrix();
      accept(CVodeSetLinearSolver(memory_, linear_solver_.get(), matrix_.get()), "its linear solver");
      accept(CVodeSetLinSysFn(memory_, linear_system), "its matrix");
      newton_ = make_accelerated_newton(context());
      accept(CVodeSetNonlinearSolver(memory_, newton_.get()), "its Newton's method");
      accept(CVodeSetMaxNonlinIters(memory_, most_iterations), "how long it iterates");
      if (projects_) {
        accept(CVodeSetProjFn(memory_, project), "its projection");
        // what errors leave along the constraints alone lets steps grow by a tenth, and errors tenfold
        accept(CVodeSetProjErrEst(memory_, 0), "errors as they are");
      }
    } else {
      fixed_point_.reset(SUNNonlinSol_FixedPoint(numbers(), 0, context()));
      accept(CVodeSetNonlinearSolver(memory_, fixed_point_.get()), "its iteration");
    }
  }
  int advance(double stop, double& t) override {
    accept(CVodeSetStopTime(memory_, stop), "where to stop");
    return CVode(memory_, stop, numbers(), &t, CV_ONE_STEP);
  }
  void interpolate_numbers(double t, N_Vector at) override {
    accept(CVodeGetDky(memory_, t, 0, at), "to interpolate");
  }
  double planned() const override {
    double h = 0;
    CVodeGetCurrentStep(memory_, &h);
    return h;
  }
  Progress progress() const override {
    long errors = 0, failures = 0, iterations = 0;
    CVodeGetNumErrTestFails(memory_, &errors);
    CVodeGetNumStepSolveFails(memory_, &failures);
    CVodeGetNumNonlinSolvIters(memory_, &iterations);
    return {errors + failures, is_implicit() ? iterations : 0};
  }

  /// The change that leads back onto the constraints.
  static int project(double t, N_Vector numbers, N_Vector change, double, N_Vector /*error*/, void* stepper) {
    Cvode& self = static_cast<Cvode&>(*static_cast<OdeStepper*>(stepper));
    return self.guarded([&] {
      FlatD projected = self.state(numbers);
      const FlatD before = projected;
      ProjectionReport<double> report;
      self.projection_(self.system(), t, projected, report);
      flat(change) = projected - before;
      return true;
    });
  }

  const bool projects_;
  void* memory_ = nullptr;
  Owned<SUNLinearSolver> linear_solver_;
  Owned<SUNMatrix> matrix_;
  Owned<SUNNonlinearSolver> newton_;
  Owned<SUNNonlinearSolver> fixed_point_;
  Projection<AnySystem<double>> projection_;
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
