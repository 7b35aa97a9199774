/// A step first adds the change of y since the last step to the offset, then lets the library advance its
/// numbers, and reads y back. The library's linear solver is an object that calls Stepper::solve.

#include "integrators/sundials/stepper.hpp"

#include <cvode/cvode.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "integrators/step_size_control.hpp"
#include "integrators/sundials/newton.hpp"

namespace trivium::integrators::sundials_library {

namespace {

/// The time to step to: the last two steps before `stop` are made equal, so that no tiny step is left.
double target(double t, double stop, double planned) {
  const double room = stop - t;
  return planned > 0 && planned < room && room < 2 * planned ? t + room / 2 : stop;
}

}  // namespace

void accept(int flag, const char* what) {
  if (flag == CV_MEM_FAIL || flag == CV_MEM_NULL)
    throw LibraryWithoutMemory();  // the codes of IDA and ARKODE too
  if (flag < 0) throw IntegrationError(fmt::format("a SUNDIALS call failed: {} (code {})", what, flag));
}

void Stepper::step(AnySystem<double>& system, double& t, StateVectorD& y, const double& stop) {
  try {
    take_step(system, t, y, stop);
  } catch (const LibraryWithoutMemory&) {
    memory_ = nullptr;  // not freed: the library would free some of what is half made twice
    throw;
  }
}

void Stepper::take_step(AnySystem<double>& system, double& t, StateVectorD& y, double stop) {
  system_ = &system;
  trouble_.clear();
  message_.clear();
  if (has_begun_ && is_outdated()) restart();
  if (has_begun_ && !keeps_nothing()) {
    offset_ += y - returned_;
  } else {
    offset_.setZero(y.size());
    before_ = counters_;
    begin(t, y, first_step_);
    first_step_ = 0;
    has_begun_ = true;
  }
  const double aim = target(t, stop, planned());
  accept(functions_.set_stop(memory_, aim), "set the stop time");
  double reached = t;
  // some failures of callbacks make the library try a shorter step, although they are to end the run
  if (advance(aim, reached) < 0 || failure_) fail(t);
  // A step of a few epsilons of t is no progress: the library could repeat such steps without end. The bound
  // 4 epsilon is that of StepSizeControl.
  constexpr double least = 4 * std::numeric_limits<double>::epsilon();
  if (reached < stop && !(reached - t > least * std::abs(t))) fail(t);
  y = state(numbers());
  // The library may end a step within its own rounding of the stop time. 1e-14, about 50 epsilon, is far
  // above the rounding of a time and far below a step.
  if (std::abs(stop - reached) <= 1e-14 * std::max(std::abs(stop), std::abs(stop - t))) reached = stop;
  last_step_ = reached - t;
  t = reached;
  returned_ = y;
  take_counters();
  ++counters_.steps;
  finish(t, y);
}

void Stepper::restart() {
  has_begun_ = false;
  first_step_ = 0;
  ++counters_.restarts;
}

bool Stepper::shorten() {
  has_begun_ = false;
  first_step_ = last_step_ / 4;  // a quarter, as StepSizeControl takes after a failure
  --counters_.steps;
  ++counters_.rejected_steps;
  return true;
}

void Stepper::interpolate(const double& t, StateVectorD& y) {
  if (!between_) between_ = own(N_VClone(numbers()));
  interpolate_numbers(t, between_.get());
  y = state(between_.get());
  finish(t, y);
}

void Stepper::interpolate_numbers(double t, N_Vector numbers) {
  accept(functions_.interpolate(memory_, t, 0, numbers), "interpolate the state");
}

double Stepper::planned() const {
  double h = 0;
  functions_.planned_step(memory_, &h);
  return h;
}

void Stepper::take_counters() {
  long errors = 0, solves = 0, iterations = 0;
  functions_.failed_errors(memory_, &errors);
  functions_.failed_solves(memory_, &solves);
  if (linear_solver_) functions_.iterations(memory_, &iterations);  // counts Newton iterations only
  counters_.rejected_steps = before_.rejected_steps + errors + solves;
  counters_.iterations = before_.iterations + iterations;
}

void Stepper::fail(double t) {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  give_up(t, trouble_.empty() ? message_ : trouble_);
}

void Stepper::make_numbers(Eigen::Index size) {
  numbers_ = own(N_VNew_Serial(size, context_));
  // N_VClone of SUNDIALS 6.4 writes to the clone without a test for null. So a failed clone, also of a clone,
  // throws through the library's functions; compilers for amd64 and arm64 give these the tables it needs.
  numbers_->ops->nvclone = [](N_Vector v) { return own(N_VClone_Serial(v)).release(); };
}

void Stepper::open(void* memory) {
  if (memory == nullptr) throw LibraryWithoutMemory();
  memory_ = memory;
  const auto note = [](int, const char*, const char*, char* message, void* stepper) {
    static_cast<Stepper*>(stepper)->message_ = message;
  };
  accept(functions_.set_error_handler(memory_, note, this), "set the error handler");
  accept(functions_.set_user_data(memory_, this), "set the user data");
}

void Stepper::measure_errors_by(int (*weights)(N_Vector, N_Vector, void*)) {
  accept(functions_.set_error_weights(memory_, weights), "set the tolerances");
}

void Stepper::begin_with(double first_step) {
  accept(functions_.set_first_step(memory_, first_step), "set the first step");
}

void Stepper::iterate_by_newton() {
  linear_solver_ = make_linear_solver();
  matrix_ = make_matrix();
  accept(functions_.set_linear_solver(memory_, linear_solver_.get(), matrix_.get()), "set the linear solver");
  iterate_by(make_accelerated_newton(context_));
  accept(functions_.set_most_iterations(memory_, most_iterations), "set the iteration limit");
}

void Stepper::iterate_by(Owned<SUNNonlinearSolver> solver) {
  nonlinear_solver_ = std::move(solver);
  accept(functions_.set_nonlinear_solver(memory_, nonlinear_solver_.get()), "set the nonlinear solver");
}

Owned<SUNLinearSolver> Stepper::make_linear_solver() {
  Owned<SUNLinearSolver> solver = own(SUNLinSolNewEmpty(context_));
  solver->content = this;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  solver->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
  solver->ops->setup = [](SUNLinearSolver, SUNMatrix) { return 0; };
  solver->ops->solve = [](SUNLinearSolver s, SUNMatrix, N_Vector x, N_Vector b, realtype) {
    Stepper& stepper = *static_cast<Stepper*>(s->content);
    return stepper.guarded([&] {
      stepper.solve(flat(b), flat(x));
      return flat(x).allFinite();
    });
  };
  solver->ops->free = [](SUNLinearSolver s) {
    SUNLinSolFreeEmpty(s);
    return 0;
  };
  return solver;
}

Owned<SUNMatrix> Stepper::make_matrix() {
  Owned<SUNMatrix> matrix = own(SUNMatNewEmpty(context_));
  matrix->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  matrix->ops->zero = [](SUNMatrix) { return 0; };
  matrix->ops->destroy = [](SUNMatrix m) { SUNMatFreeEmpty(m); };
  return matrix;
}

}  // namespace trivium::integrators::sundials_library
