/// The iteration is a class of its own; a SUNNonlinearSolver, the table of functions that the library calls,
/// forwards to it.

#include "integrators/sundials/newton.hpp"

#include "integrators/implicit/anderson.hpp"

namespace trivium::integrators::sundials_library {

namespace {

/// The functions that an integrator of SUNDIALS hands over, and the state of the iteration.
class AcceleratedNewton {
 public:
  static AcceleratedNewton& of(SUNNonlinearSolver solver) {
    return *static_cast<AcceleratedNewton*>(solver->content);
  }

  SUNNonlinSolSysFn system = nullptr;
  SUNNonlinSolLSetupFn set_up = nullptr;
  SUNNonlinSolLSolveFn solve_linear = nullptr;
  SUNNonlinSolConvTestFn test = nullptr;
  void* test_data = nullptr;
  int most_iterations = 3, iteration = 0;  ///< 3: the default of Newton's method in SUNDIALS
  long iterations = 0, failures = 0;       ///< in the last solve

  /// Iterates for the correction y of the predicted state, from the given y. If the iteration fails with an
  /// old matrix, it starts once more with a new one. Returns the library's code.
  int solve(SUNNonlinearSolver solver, N_Vector y, N_Vector weights, double tolerance, bool needs_matrix,
            void* memory) {
    if (!left_) left_ = own(N_VClone(y));
    start_ = flat(y);
    iterations = failures = 0;
    for (bool is_bad = false;;) {
      bool is_current = false;
      const int code = iterate(solver, y, weights, tolerance, needs_matrix, is_bad, is_current, memory);
      if (code == SUN_NLS_SUCCESS) return code;
      if (code < 0 || is_current || is_bad || set_up == nullptr) {
        ++failures;
        return code;
      }
      needs_matrix = is_bad = true;
      flat(y) = start_;
    }
  }

 private:
  int iterate(SUNNonlinearSolver solver, N_Vector y, N_Vector weights, double tolerance, bool needs_matrix,
              bool is_bad, bool& is_current, void* memory) {
    anderson_.clear();
    for (iteration = 0; iteration < most_iterations; ++iteration) {
      if (const int code = system(y, left_.get(), memory); code != 0) return code;
      if (iteration == 0 && needs_matrix) {
        int is_made = 0;
        if (const int code = set_up(is_bad, &is_made, memory); code != 0) return code;
        is_current = is_made != 0;
      }
      flat(left_.get()) *= -1;
      if (const int code = solve_linear(left_.get(), memory); code != 0) return code;
      ++iterations;
      const auto w = flat(weights);
      change_ = flat(left_.get()).cwiseProduct(w);
      // The first change removes the error that the matrix describes. Later changes come from terms that the
      // matrix leaves out. The second one is recorded, and from the third on changes are accelerated.
      if (iteration > 0) flat(left_.get()) = anderson_.step(change_, change_.size()).cwiseQuotient(w);
      flat(y) += flat(left_.get());
      // The test reports divergence if the changes grow. Such a report is ignored at the first two changes,
      // which are not accelerated.
      const int code = test(solver, y, left_.get(), tolerance, weights, test_data);
      if (code != SUN_NLS_CONTINUE && !(code == SUN_NLS_CONV_RECVR && iteration < 2)) return code;
    }
    return SUN_NLS_CONV_RECVR;
  }

  Owned<N_Vector> left_;
  StateVectorD start_, change_;
  Anderson<double> anderson_;
};

}  // namespace

Owned<SUNNonlinearSolver> make_accelerated_newton(SUNContext context) {
  using Newton = AcceleratedNewton;
  Owned<SUNNonlinearSolver> solver = own(SUNNonlinSolNewEmpty(context));
  solver->content = new Newton;
  auto& ops = *solver->ops;
  ops.gettype = [](SUNNonlinearSolver) { return SUNNONLINEARSOLVER_ROOTFIND; };
  ops.free = [](SUNNonlinearSolver s) {
    delete &Newton::of(s);
    SUNNonlinSolFreeEmpty(s);
    return SUN_NLS_SUCCESS;
  };
  ops.setsysfn = [](SUNNonlinearSolver s, SUNNonlinSolSysFn f) {
    Newton::of(s).system = f;
    return SUN_NLS_SUCCESS;
  };
  ops.setlsetupfn = [](SUNNonlinearSolver s, SUNNonlinSolLSetupFn f) {
    Newton::of(s).set_up = f;
    return SUN_NLS_SUCCESS;
  };
  ops.setlsolvefn = [](SUNNonlinearSolver s, SUNNonlinSolLSolveFn f) {
    Newton::of(s).solve_linear = f;
    return SUN_NLS_SUCCESS;
  };
  ops.setctestfn = [](SUNNonlinearSolver s, SUNNonlinSolConvTestFn f, void* data) {
    Newton::of(s).test = f;
    Newton::of(s).test_data = data;
    return SUN_NLS_SUCCESS;
  };
  ops.setmaxiters = [](SUNNonlinearSolver s, int most) {
    Newton::of(s).most_iterations = most;
    return SUN_NLS_SUCCESS;
  };
  ops.getnumiters = [](SUNNonlinearSolver s, long* number) {
    *number = Newton::of(s).iterations;
    return SUN_NLS_SUCCESS;
  };
  ops.getcuriter = [](SUNNonlinearSolver s, int* number) {
    *number = Newton::of(s).iteration;
    return SUN_NLS_SUCCESS;
  };
  ops.getnumconvfails = [](SUNNonlinearSolver s, long* number) {
    *number = Newton::of(s).failures;
    return SUN_NLS_SUCCESS;
  };
  ops.solve = [](SUNNonlinearSolver s, N_Vector, N_Vector y, N_Vector weights, double tolerance,
                 int needs_matrix, void* memory) {
    return Newton::of(s).solve(s, y, weights, tolerance, needs_matrix != 0, memory);
  };
  return solver;
}

}  // namespace trivium::integrators::sundials_library
