#pragma once
/// One of SUNDIALS' integrators taken step by step, as far as CVODE, ARKODE and IDA are alike. The library
/// decides the length of a step and whether its iteration diverges; integrate.hpp decides that a finished
/// step is taken back.

#include <sundials/sundials_context.h>

#include <exception>
#include <string>

#include "integrators/contract/any_method.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/sundials/owned.hpp"

namespace trivium::integrators::sundials_library {

/// What CVODE, ARKODE and IDA each have under a name of its own.
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

/// The library's numbers are y less an offset: what projections after its steps change goes to the offset,
/// so that all that it remembers of the past moves along with y, and nothing of it is lost.
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
  // what the integrators differ in
  /// Begins at (t, y) with a first step, or one of its own choice where that is 0.
  virtual void begin(double t, const StateVectorD& y, double first_step) = 0;
  /// One step from t, at most to `stop`; leaves the library's state in numbers(). Returns the library's flag.
  virtual int advance(double stop, double& t) = 0;
  /// Whether it keeps nothing of a step for the next: each is then the first.
  virtual bool keeps_nothing() const { return false; }
  /// The length it would take next; 0 where steps are given.
  virtual double planned() const;
  /// A x = b with what was factored last.
  virtual void solve(const Eigen::Map<StateVectorD>& b, Eigen::Map<StateVectorD> x) = 0;
  /// The library's numbers at a time of its last step.
  virtual void interpolate_numbers(double t, N_Vector numbers);
  /// What is left to do to a state of a step or of between.
  virtual void finish(double /*t*/, StateVectorD& /*y*/) {}

  /// Runs what the library calls back. Returns its code: 0, 1 where a shorter step may do, -1 where not.
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
  /// y from the library's numbers.
  const StateVectorD& state(N_Vector numbers) {
    y_ = flat(numbers).head(offset_.size()) + offset_;
    return y_;
  }
  /// Of what is measured neither by the estimated error nor by Newton's method.
  static constexpr double no_weight = 1e-100;
  void weigh(const StateVectorD& y, const Tolerances& tolerances, Eigen::Map<StateVectorD> weights) const {
    weights.head(y.size()) = (tolerances.rtol * y.array().abs() + tolerances.atol).inverse();
  }

  SUNContext context() { return context_; }
  AnySystem<double>& system() { return *system_; }
  N_Vector numbers() { return numbers_.get(); }
  void make_numbers(Eigen::Index size) { numbers_.reset(N_VNew_Serial(size, context_)); }
  void* library_memory() const { return memory_; }
  /// Takes what the library made; it calls back with the stepper as its user data.
  void open(void* memory);
  void measure_errors_by(int (*weights)(N_Vector, N_Vector, void*));
  void begin_with(double first_step);
  /// Newton's method whose linear systems are those of solve().
  void iterate_by_newton();
  void iterate_by(Owned<SUNNonlinearSolver> solver);

  Counters counters_;

 private:
  void fail(double t, const StateVectorD& y);
  void take_counters();
  /// A linear solver that calls solve(), and a matrix in name, which the library asks for.
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
  Counters before_;  ///< when it began last
  std::string trouble_, message_;
  std::exception_ptr failure_;
};

/// Throws where the library refuses a setting.
void accept(int flag, const char* what);

}  // namespace trivium::integrators::sundials_library
