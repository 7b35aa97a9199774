#pragma once
/// The common part of CVODE, ARKODE and IDA: one step at a time of a SUNDIALS integrator. The library chooses
/// the step size and decides whether its iteration diverges; integrate.hpp decides whether a finished step is
/// taken back.

#include <sundials/sundials_context.h>

#include <exception>
#include <string>

#include "integrators/contract/any_method.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/sundials/owned.hpp"

namespace trivium::integrators::sundials_library {

/// Functions that CVODE, ARKODE and IDA all have, under different names.
struct Functions {
  void (*free)(void** memory);
  int (*set_error_handler)(void*, void (*)(int, const char*, const char*, char*, void*), void*);
  int (*set_user_data)(void*, void*);
  int (*set_error_weights)(void*, int (*)(N_Vector, N_Vector, void*));
  int (*set_linear_solver)(void*, SUNLinearSolver, SUNMatrix);
  int (*set_nonlinear_solver)(void*, SUNNonlinearSolver);
  int (*set_most_iterations)(void*, int);
  int (*set_first_step)(void*, double);
  int (*set_stop)(void*, double);
  int (*interpolate)(void*, double, int, N_Vector);
  int (*planned_step)(void*, double*);
  int (*failed_errors)(void*, long*);
  int (*failed_solves)(void*, long*);
  int (*iterations)(void*, long*);
};

/// The numbers that the library integrates are y minus an offset. A projection after a step changes y; this
/// change is added to the offset, and the library's numbers do not change. In this way the library's history
/// of past steps moves along with y, and no restart is needed.
class Stepper : public AnyMethod<double> {
 public:
  explicit Stepper(const Functions& functions) : functions_(functions) {}
  ~Stepper() override { functions_.free(&memory_); }
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  void step(AnySystem<double>& system, double& t, StateVectorD& y, const double& stop) final;
  void restart() final;
  bool shorten() override;
  void interpolate(const double& t, StateVectorD& y) final;
  const Counters& counters() const final { return counters_; }
  const StateVectorD* lambda() const override { return nullptr; }

 protected:
  // the functions in which the integrators differ
  /// Begins at (t, y). A first_step of 0 lets the integrator choose its first step size.
  virtual void begin(double t, const StateVectorD& y, double first_step) = 0;
  /// Takes one step from t, at most to `stop`; leaves the library's state in numbers(). Returns the library's
  /// flag.
  virtual int advance(double stop, double& t) = 0;
  /// Whether nothing is kept from step to step: each step is then a first step.
  virtual bool keeps_nothing() const { return false; }
  /// Whether what is kept no longer belongs to the system, so that the method must begin again.
  virtual bool is_outdated() { return false; }
  /// The size that the library plans for its next step; 0 with given steps.
  virtual double planned() const;
  /// Solves A x = b with the factors made last.
  virtual void solve(const Eigen::Map<StateVectorD>& b, Eigen::Map<StateVectorD> x) = 0;
  /// Sets `numbers` to the library's state at a time within its last step.
  virtual void interpolate_numbers(double t, N_Vector numbers);
  /// Completes the state at the end of a step, or an interpolated state.
  virtual void finish(double /*t*/, StateVectorD& /*y*/) {}

  /// Runs a callback of the library. Returns the library's code: 0; 1 if a shorter step may help; -1 if not.
  template <class Work>
  int guarded(const Work& work) noexcept {
    try {
      return work() ? 0 : 1;
    } catch (const UsageError&) {
      failure_ = std::current_exception();
      return -1;
    } catch (const std::runtime_error& error) {
      trouble_ = error.what();
      return 1;
    } catch (...) {
      failure_ = std::current_exception();
      return -1;
    }
  }

  bool has_begun() const { return has_begun_; }
  /// The state y that belongs to the library's numbers.
  const StateVectorD& state(N_Vector numbers) {
    y_ = flat(numbers).head(offset_.size()) + offset_;
    return y_;
  }
  /// The weight of elements that count neither in error estimates nor in convergence tests; SUNDIALS requires
  /// positive weights.
  static constexpr double no_weight = 1e-100;
  void weigh(const StateVectorD& y, const Tolerances& tolerances, Eigen::Map<StateVectorD> weights) const {
    weights.head(y.size()) = (tolerances.rtol * y.array().abs() + tolerances.atol).inverse();
  }

  SUNContext context() { return context_; }
  AnySystem<double>& system() { return *system_; }
  N_Vector numbers() { return numbers_.get(); }
  void make_numbers(Eigen::Index size);
  void* library_memory() const { return memory_; }
  /// Takes the memory that the library has allocated; its callbacks receive the stepper as user data.
  void open(void* memory);
  void measure_errors_by(int (*weights)(N_Vector, N_Vector, void*));
  void begin_with(double first_step);
  /// Uses Newton's method, with linear systems solved by solve().
  void iterate_by_newton();
  void iterate_by(Owned<SUNNonlinearSolver> solver);

  Counters counters_;

 private:
  void take_step(AnySystem<double>& system, double& t, StateVectorD& y, double stop);
  [[noreturn]] void fail(double t);
  void take_counters();
  /// A linear solver that calls solve(), and an empty matrix that the library requires.
  Owned<SUNLinearSolver> make_linear_solver();
  Owned<SUNMatrix> make_matrix();

  const Functions& functions_;
  void* memory_ = nullptr;
  ::sundials::Context context_;
  Owned<N_Vector> numbers_, between_;
  Owned<SUNLinearSolver> linear_solver_;
  Owned<SUNMatrix> matrix_;
  Owned<SUNNonlinearSolver> nonlinear_solver_;
  AnySystem<double>* system_ = nullptr;
  StateVectorD offset_, returned_, y_;
  double first_step_ = 0, last_step_ = 0;
  bool has_begun_ = false;
  Counters before_;  ///< counters when the integrator last began
  std::string trouble_, message_;
  std::exception_ptr failure_;
};

/// Throws an IntegrationError if the library refuses a setting, and LibraryWithoutMemory if it has no memory.
void accept(int flag, const char* what);

}  // namespace trivium::integrators::sundials_library
