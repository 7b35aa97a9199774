/// The method of IDA for the stabilised index-2 equations, with the linear systems of its iterations.

#include <ida/ida.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/raise.hpp"
#include "integrators/projection_iteration.hpp"
#include "integrators/step_size_control.hpp"
#include "integrators/sundials/methods.hpp"
#include "integrators/sundials/stepper.hpp"

namespace trivium::integrators {

namespace sundials_library {

namespace {

const Functions ida{.free = IDAFree,
                    .set_error_handler = IDASetErrHandlerFn,
                    .set_user_data = IDASetUserData,
                    .set_error_weights = IDAWFtolerances,
                    .set_linear_solver = IDASetLinearSolver,
                    .set_nonlinear_solver = IDASetNonlinearSolver,
                    .set_most_iterations = IDASetMaxNonlinIters,
                    .set_first_step = IDASetInitStep,
                    .set_stop = IDASetStopTime,
                    .interpolate = IDAGetDky,
                    .planned_step = IDAGetCurrentStep,
                    .failed_errors = IDAGetNumErrTestFails,
                    .failed_solves = IDAGetNumStepSolveFails,
                    .iterations = IDAGetNumNonlinSolvIters};

/// IDA for the stabilised index-2 equations. The unknowns are y = (q, v, work), lambda and sigma:
///
///   q' = v + s,   M v' + Phi_q^T lambda = Q,   Phi_q v = nu,   Phi = 0
///
/// Here s is the smallest motion, in the metric of M, that moves the rows by sigma: M s + Phi_q^T mu = 0 and
/// Phi_q s = sigma. M and Phi_q in these two equations are those of the matrix factored last, where M
/// contains the resistance C/c + K/c^2 of springs with stiffness K and damping C; c is the derivative of y'
/// by y in IDA's formula. In the solution sigma is 0. Internal rows are met by v' and by the projection after
/// each step.
class Ida final : public Stepper {
 public:
  explicit Ida(const Tolerances& tolerances) : Stepper(ida), tolerances_(tolerances) {}

  bool interpolates() const override { return true; }
  const StateVectorD* lambda() const override { return has_begun() ? &lambda_ : nullptr; }

 private:
  /// Whether a row with a multiplier has become dependent: another row takes over its force, and the
  /// multipliers of past steps no longer predict those of the next.
  bool is_outdated() override {
    cleared_ = lambda_;
    system().clear_dependent(cleared_);
    return cleared_ != lambda_;
  }
  void begin(double t, const StateVectorD& y, double first_step) override {
    nq_ = system().position_size();
    nv_ = system().velocity_size();
    nc_ = system().multipliers();
    ny_ = static_cast<int>(y.size());
    const bool is_new = library_memory() == nullptr;
    if (is_new) {
      make_numbers(ny_ + 2 * nc_);
      rates_ = own(N_VClone(numbers()));
      is_differential_ = own(N_VClone(numbers()));
      flat(is_differential_.get()).setZero();
      flat(is_differential_.get()).head(ny_).setOnes();
    }
    system().derivative(t, y, y_dot_);
    system().accelerations(t, y, v_dot_, lambda_);
    system().evaluate(t, y, linearised_);
    system().applied_force(linearised_, force_at_);
    system().inertia_force(linearised_, y.segment(nq_, nv_), force_);
    momentum_ = nv_ > 0 ? force_.cwiseAbs().maxCoeff() : 0.0;
    energy_ = 0;
    system().factor(linearised_, {}, factors_);
    counters_.right_sides += 2;
    flat(numbers()) << y, lambda_, StateVectorD::Zero(nc_);
    flat(rates_.get()) << y_dot_, StateVectorD::Zero(2 * nc_);
    if (is_new)
      make(t);
    else
      accept(IDAReInit(library_memory(), t, numbers(), rates_.get()), "restart");
    const double first = first_step > 0 ? first_step : first_step_of(t, y);
    c_ = 1 / first;
    begin_with(first);
  }
  double first_step_of(double t, const StateVectorD& y) {
    return integrators::first_step(system(), t, y, 1, tolerances_, counters_.right_sides);
  }
  void make(double t) {
    open(IDACreate(context()));
    accept(IDAInit(library_memory(), residual, t, numbers(), rates_.get()), "set the initial state");
    measure_errors_by(error_weights);
    accept(IDASetId(library_memory(), is_differential_.get()), "set the differential unknowns");
    accept(IDASetSuppressAlg(library_memory(), 1), "leave the multipliers out of the error estimate");
    // The library's default is 0.33. An error of the positions along a stiff spring is a large error of its
    // force, which the error estimates of later steps show. 0.01 is chosen by experiment: a larger value
    // makes these estimates shorten the steps, a smaller one costs iterations.
    accept(IDASetNonlinConvCoef(library_memory(), 0.01), "set the tolerance of Newton's method");
    iterate_by_newton();
    accept(IDASetJacFn(library_memory(), factor), "set the matrix");
  }
  int advance(double stop, double& t) override {
    const int flag = IDASolve(library_memory(), stop, &t, numbers(), rates_.get(), IDA_ONE_STEP);
    lambda_ = flat(numbers()).segment(ny_, nc_);
    return flag;
  }
  void interpolate_numbers(double t, N_Vector at) override {
    Stepper::interpolate_numbers(t, at);
    lambda_ = flat(at).segment(ny_, nc_);
  }
  void finish(double t, StateVectorD& y) override {
    ProjectionReport<double> report;
    projection_(system(), t, y, report);
  }

  static Ida& of(void* stepper) { return static_cast<Ida&>(*static_cast<Stepper*>(stepper)); }

  static int residual(double t, N_Vector numbers, N_Vector rates, N_Vector left, void* stepper) {
    Ida& self = of(stepper);
    return self.guarded([&] {
      self.evaluate(t, numbers, rates, self.evaluated_);
      flat(left) << self.off_q_, -self.off_v_, self.off_work_, self.phi_dot_, self.phi_;
      return flat(left).allFinite();
    });
  }
  /// Evaluates the model and the residuals of all equations at the library's numbers; `at` keeps the model.
  void evaluate(double t, N_Vector numbers, N_Vector rates, AnyEvaluation& at) {
    ++counters_.right_sides;
    AnySystem<double>& system = this->system();
    const StateVectorD& y = state(numbers);
    system.evaluate(t, y, at);
    lambda_ = flat(numbers).segment(ny_, nc_);
    move(linearised_, y, y.segment(nq_, nv_), flat(numbers).tail(nc_));
    off_q_ = flat(rates).head(nq_) - rate_;
    v_dot_ = flat(rates).segment(nq_, nv_);
    system.inertia_force(at, v_dot_, force_);
    system.residual(at, force_, lambda_, off_v_);
    system.internal_residual(at, v_dot_, off_v_);
    system.position_rows(at, phi_);
    system.velocity_rows(at, phi_dot_);
    off_work_.resize(ny_ - nq_ - nv_);
    if (off_work_.size() > 0) off_work_[0] = flat(rates)[nq_ + nv_] - system.work_rate(at, lambda_);
  }
  /// Sets rate_ to q', where the motion is v plus the smallest motion that moves the rows by sigma.
  void move(const AnyEvaluation& at, const StateVectorD& y, const StateVectorD& v,
            const StateVectorD& sigma) {
    moved_ = v;
    if (!sigma.isZero(0)) {
      mu_.setZero(nc_);
      system().solve(factors_, at, StateVectorD::Zero(nv_), sigma, moved_, mu_);
    }
    system().position_rate(y, moved_, rate_);
  }

  static int factor(double t, double c, N_Vector numbers, N_Vector rates, N_Vector, SUNMatrix, void* stepper,
                    N_Vector, N_Vector, N_Vector) {
    Ida& self = of(stepper);
    return self.guarded([&] {
      self.evaluate(t, numbers, rates, self.linearised_);
      self.system().applied_force(self.linearised_, self.force_at_);
      self.system().factor(self.linearised_, {1 / (c * c), 1 / c}, self.factors_);
      self.at_ = self.state(numbers);
      self.at_t_ = t;
      self.c_ = c;
      self.phi_dot_at_ = self.phi_dot_;
      return true;
    });
  }
  /// Solves Newton's system J x = b. The parts of b belong to these residuals: b_q to q', b_v to the forces,
  /// b_w to the work, b_nu to the velocity rows Phi_q v = nu, b_phi to the position rows Phi = 0. The parts
  /// of x belong to q, v, work, lambda and sigma. c is the derivative of y' by y in IDA's formula. The part
  /// of the work is b_w / c. For the others three systems are solved one after the other. The first gives d,
  /// the change that q would have if v did not change. sigma_0 is the sigma for which d meets the position
  /// rows,
  ///
  ///   c d = b_q + s(sigma_0),   Phi_q d = b_phi
  ///
  /// The second gives the change x_v = u / c of the velocities. The springs resist by their stiffness K and
  /// damping C. The right sides contain the changes of Q (only if the system
  /// has springs) and of the velocity rows over d,
  ///
  ///   (M + C/c + K/c^2) u + Phi_q^T x_lambda = b_v + Q(q + d, v) - Q(q, v)
  ///
  ///   Phi_q u = c (b_nu - (change of Phi_q v over d))
  ///
  /// The third gives the change of q, with the x_sigma for which it meets the position rows,
  ///
  ///   c x_q = b_q + x_v + s(x_sigma),   Phi_q x_q = b_phi
  void solve(const Eigen::Map<StateVectorD>& b, Eigen::Map<StateVectorD> x) override {
    AnySystem<double>& system = this->system();
    const StateVectorD b_v = b.segment(nq_, nv_), b_phi = b.tail(nc_);
    StateVectorD moved = at_;
    moved.head(nq_) += b.head(nq_);
    system.displacement(at_, moved, displacement_);
    const StateVectorD v = at_.segment(nq_, nv_), along = rows_of(at_, v + displacement_) - phi_dot_at_;
    move(linearised_, at_, StateVectorD::Zero(nv_), c_ * b_phi - along);
    moved = at_;
    moved.head(nq_) += (b.head(nq_) + rate_) / c_;
    const StateVectorD b_phi_dot = b.segment(ny_, nc_) - (rows_of(moved, v) - phi_dot_at_);
    StateVectorD u = StateVectorD::Zero(nv_), x_lambda = StateVectorD::Zero(nc_);
    system.solve(factors_, evaluated_, b_v, c_ * b_phi_dot, u, x_lambda);
    system.solve_internal_rows(linearised_, b_v, u);
    if (system.springs() > 0) {
      system.applied_force(evaluated_, moved_force_);
      system.reduce(factors_, moved_force_ - force_at_, left_);
      no_rows_.setZero(nc_);
      system.solve(factors_, evaluated_, left_, no_rows_, u, x_lambda);
    }
    const StateVectorD x_v = u / c_, x_sigma = c_ * b_phi - b_phi_dot - along;
    move(linearised_, at_, x_v, x_sigma);
    x << (b.head(nq_) + rate_) / c_, x_v, b.segment(nq_ + nv_, ny_ - nq_ - nv_) / c_, x_lambda, x_sigma;
  }
  /// Phi_q v - nu at the positions of y; evaluated_ becomes the model there.
  StateVectorD rows_of(const StateVectorD& y, const StateVectorD& v) {
    StateVectorD at = y, rows;
    at.segment(nq_, nv_) = v;
    system().evaluate(at_t_, at, evaluated_);
    system().velocity_rows(evaluated_, rows);
    return rows;
  }

  static int error_weights(N_Vector numbers, N_Vector weights, void* stepper) {
    Ida& self = of(stepper);
    Eigen::Map<StateVectorD> w = flat(weights);
    self.weigh(self.state(numbers), self.tolerances_, w);
    self.keep_above_rounding(self.state(numbers), w);
    // sigma is 0 and does not count in error estimates and convergence tests.
    // IDA's norm is the root mean square over all unknowns. The factor makes it the one over q and v, so that
    // the error of a step does not depend on the number of multipliers.
    w.tail(w.size() - self.nq_ - self.nv_).setConstant(no_weight);
    w.head(self.nq_ + self.nv_) *=
        std::sqrt(static_cast<double>(w.size()) / static_cast<double>(self.nq_ + self.nv_));
    self.weigh_work(self.state(numbers), w);
    self.weigh_multipliers(flat(numbers).segment(self.ny_, self.nc_), w.segment(self.ny_, self.nc_));
    return 0;
  }

  /// Newton's iteration must reach a hundredth of the tolerance in every number. A number far smaller than
  /// the others, whose tolerance would be below their rounding, has a thousand roundings of the largest
  /// position or velocity as its tolerance.
  void keep_above_rounding(const StateVectorD& y, Eigen::Ref<StateVectorD> weights) const {
    constexpr double roundings = 1000 * std::numeric_limits<double>::epsilon();
    const auto bound = [&](int first, int size) {
      const double least = roundings * y.segment(first, size).cwiseAbs().maxCoeff();
      if (least > 0) weights.segment(first, size) = weights.segment(first, size).cwiseMin(1 / least);
    };
    bound(0, nq_);
    bound(nq_, nv_);
  }

  /// The weight of the work. Where the motion is a polynomial of low order, as under a driver, its errors
  /// vanish, and steps would grow until they do not resolve the power. The tolerance is a share of the work
  /// and of the largest kinetic energy, and another of the work within a step, without which steps do not
  /// pass the dead point of a driver. Both are chosen by experiment; they are far looser than the tolerances
  /// of the motion.
  void weigh_work(const StateVectorD& y, Eigen::Ref<StateVectorD> weights) {
    const int work = nq_ + nv_;
    if (ny_ == work) return;
    const StateVectorD v = y.segment(nq_, nv_);
    system().inertia_force(linearised_, v, force_);
    raise(energy_, v.dot(force_) / 2);
    const double share = std::max(1e-5, tolerances_.rtol), share_of_step = 1e-4;
    const double of_step = std::abs(flat(rates_.get())[work]) / c_;
    weights[work] = 1 / (share * (energy_ + std::abs(y[work])) + share_of_step * of_step + tolerances_.atol);
  }

  /// Sets the weights of lambda, which count in convergence tests only. The tolerance is 1e-4 of a multiplier
  /// plus 1e-7 of the sum of the largest multiplier and the largest force. Both are chosen by experiment:
  /// tighter tolerances cost Newton iterations that q and v do not need, looser ones show in lambda at the
  /// outputs. lambda follows from
  /// the velocity rows at the end of a step: in a short step, rounding of the momenta is a large part of it.
  /// The tolerance is at least a million times this rounding, so that a hundredth of it can be reached. A
  /// million is chosen by experiment, with masses of 1 kg beside 1e6 kg.
  void weigh_multipliers(const Eigen::Ref<const StateVectorD>& lambda,
                         Eigen::Ref<StateVectorD> weights) const {
    if (lambda.size() == 0) return;
    constexpr double share = 1e-4, roundings = 1e6;
    const double largest = lambda.cwiseAbs().maxCoeff() + force_at_.cwiseAbs().maxCoeff();
    if (largest > 0)
      weights = (share * (lambda.array().abs() + 1e-3 * largest))
                    .max(roundings * std::numeric_limits<double>::epsilon() * c_ * momentum_)
                    .inverse();
  }

  Tolerances tolerances_;
  int nq_ = 0, nv_ = 0, nc_ = 0, ny_ = 0;
  double energy_ = 0;    ///< largest kinetic energy since the integrator last began [J]
  double momentum_ = 0;  ///< largest component of M v where the integrator last began
  Owned<N_Vector> rates_, is_differential_;
  ProjectionIteration<AnySystem<double>> projection_;
  StateVectorD lambda_, cleared_, y_dot_, v_dot_, force_, mu_, moved_, rate_, displacement_;
  StateVectorD off_q_, off_v_, off_work_, phi_, phi_dot_;  ///< residuals of the equations
  StateVectorD at_, phi_dot_at_, force_at_;                ///< values where the matrix was factored
  AnyEvaluation evaluated_, linearised_;                   ///< models: evaluated last; of the factored matrix
  AnyFactors factors_;
  StateVectorD moved_force_, left_, no_rows_;
  double at_t_ = 0, c_ = 1;
};

}  // namespace

}  // namespace sundials_library

DoubleMethod make_ida(const Tolerances& tolerances) {
  return std::make_unique<sundials_library::Ida>(tolerances);
}

}  // namespace trivium::integrators
