#pragma once
/// The equations of motion of one formulation as ordinary differential equations y' = f(t, y), with y as in
/// state_layout.hpp. Two derivatives of the constraints reduce the differential-algebraic equations from
/// index 3 to index 1; a linear system then gives accelerations and lambda at every (t, y). Other files of
/// this folder provide the parts: projection and violation of constraints, energy, charts, jumps of
/// velocities, the branch check and the log.
///
/// This file decides two things: how dependent rows are detected, and which solutions are refined. Dependent
/// rows are detected at every accepted state and kept within a step; the start of the motion decides how they
/// are detected. Solutions between accepted states are refined only if the last accepted state showed that it
/// is necessary.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "formulations/near_singular_chart.hpp"
#include "simulation/system/branch_check.hpp"
#include "simulation/system/chart_switching.hpp"
#include "simulation/system/constraint_projection.hpp"
#include "simulation/system/dead_points.hpp"
#include "simulation/system/diagnosis.hpp"
#include "simulation/system/discontinuities.hpp"
#include "simulation/system/energy_account.hpp"
#include "simulation/system/loads_by_effect.hpp"
#include "simulation/system/motion_log.hpp"
#include "simulation/system/saved_numbers.hpp"
#include "simulation/system/state_layout.hpp"

namespace trivium {

/// Options of a motion: its charts, Baumgarte's stabilisation, projection, and the run that it continues.
struct FirstOrderOptions {
  ChartOptions charts;
  std::optional<Baumgarte> baumgarte;
  bool is_projected = true;        ///< false: constraints drift, which makes dependent rows look independent
  const SavedRun* from = nullptr;  ///< saved run in this formulation to continue from, at the start's time

  /// Start time of the first of all continued runs, at which the scales of rows are taken [s].
  template <class S>
  S first_start(const S& t) const {
    return from ? S(from->start) : t;
  }
};

/// The motion of a copy of one mechanism as y' = f(t, y). A model of the concept
/// integrators::FirstOrderSystem, which defines its functions.
template <Formulation F>
class FirstOrderEquations {
 public:
  using Scalar = typename F::Scalar;
  using S = Scalar;
  using StateVector = VectorX<S>;

  /// Throws a ModelError that names a body with a singular chart, or an Error if the saved run does not fit.
  FirstOrderEquations(const MechanismOf<F>& mechanism, const MechanismState<S>& start,
                      const FirstOrderOptions& options = {})
      : mechanism_(mechanism),
        layout_(mechanism_.nb()),
        solver_(mechanism_),
        state_(to_coordinates<F>(mechanism_, start, options.charts)),
        motion_(mechanism_.nb() + 1),
        projection_(solver_, options.first_start(start.t)),
        account_(mechanism_),
        charts_(options.charts),
        branches_(mechanism_.nb()),
        lambda_(mechanism_.nc()),
        start_of_motion_{start, {}} {
    if (options.baumgarte) solver_.stabilise(*options.baumgarte);
    limits_steps_ = mechanism_.effects.limit_steps();
    start_ = StateVector::Zero(size());
    for (int b = 0; b < nb(); ++b) {
      layout_.place(start_, b) << state_[b].r, F::orientation_of(state_[b].chart, start.pose[b].p);
      layout_.rate(start_, b) << state_[b].r_dot, F::velocity_of(state_[b].chart, state_[b].q);
    }
    if (options.from)
      go_on_from(*options.from, start, options.is_projected);
    else
      begin(start, options.is_projected);
    start_of_motion_.motion = motion_;
  }

  int nb() const { return mechanism_.nb(); }
  int size() const { return motion_size() + (does_work() ? 1 : 0); }
  /// The length of (q, v), without the work.
  int motion_size() const { return layout_.motion_size(); }
  const StateLayout<F>& layout() const { return layout_; }
  const StateVector& start() const { return start_; }

  /// y' at (t, y). Throws a ModelError if the accelerations cannot be solved for.
  void derivative(const S& t, const StateVector& y, StateVector& y_dot) {
    solve(t, y);
    y_dot.resize(size());
    for (int b = 0; b < nb(); ++b) {
      const BodyState<F>& body = state_[b];
      layout_.place(y_dot, b) << body.r_dot,
          F::orientation_rate(body.chart, layout_.orientation(y, b), layout_.velocity(y, b));
      layout_.rate(y_dot, b) << solver_.r_ddot(b), solver_.q_ddot(b);
    }
    if (!does_work()) return;
    solver_.copy_lambda(lambda_);
    take_motion();
    y_dot[motion_size()] = account_.power(view(t), solver_.assembly().body(), lambda_);
  }

  // constraints: their violation, and one correction
  integrators::Violation<S> position_violation(const S& t, const StateVector& y) {
    move_to(t, y, Rows::positions);
    return projection_.measure_positions();
  }
  integrators::Violation<S> velocity_violation(const S& t, const StateVector& y) {
    move_to(t, y, Rows::velocities);
    return projection_.measure_velocities();
  }
  /// Whether a projection is so large that it may have left the branch of the motion (branch_check.hpp).
  bool projection_is_too_large(const StateVector& before, const StateVector& stepped,
                               const StateVector& projected) {
    return branches_.projection_is_too_large(layout_, projection_.measure(), before, stepped, projected);
  }
  /// The longest step from (t, y) [s] after which effects can still count the turns of their joints.
  S longest_step(const S& t, const StateVector& y) {
    if (!limits_steps_) return std::numeric_limits<S>::max();
    move_bodies(t, y);
    return mechanism_.effects.longest_step(view(t));
  }
  const std::string& row_name(int row) const { return projection_.measure().row_name(row); }
  /// One projection step of the positions, with the matrix factored at y if `factor`, else the last factors.
  void correct_positions(const S& t, StateVector& y, bool factor) {
    if (!is_measured(t, y, Rows::positions)) position_violation(t, y);
    projection_.correct_positions(layout_, state_, y, factor);
  }
  void correct_velocities(const S& t, StateVector& y, bool factor) {
    if (!is_measured(t, y, Rows::velocities)) velocity_violation(t, y);
    projection_.correct_velocities(layout_, state_, y, factor);
  }
  /// Meets the internal rows of the formulation, such as |p| = 1, by normalisation.
  void normalise(StateVector& y) const {
    for (int b = 0; b < nb(); ++b) {
      typename F::Orientation x = layout_.orientation(y, b);
      typename F::Unknown v = layout_.velocity(y, b);
      F::normalise(x, v);
      layout_.place(y, b).tail(F::orientation_size) = x;
      layout_.rate(y, b).tail(F::rotational_unknowns) = v;
    }
  }

  /// Accepts a state: changes the charts of bodies near their singularity, removes full turns from angles,
  /// detects the dependent rows, and lets effects count turns. Returns whether coordinates of y changed by
  /// charts or turns. Throws a ModelError, also at a dead point (dead_points.hpp).
  bool accept_state(const S& t, StateVector& y) {
    solved_t_.reset();
    const bool reframed = reframe(t, y);
    solve_as(t, y, Refinement::as_needed, detection_);
    if (leaves_out_rows_of_light_bodies()) {
      detection_ = DependentRows::detect;
      solve_as(t, y, Refinement::as_needed, detection_);
    }
    log_.note_dependent_rows(t, solver_.factors().dependent_row_count());
    refines_ = !(solver_.corrections().acceleration <= small_correction);
    solved_t_ = t;
    solved_ = y;
    projection_.accept_state();
    take_motion();
    mechanism_.effects.follow(view(t));
    dead_points_.check(mechanism_, account_.drivers(), solver_.assembly().body(), t);
    return reframed;
  }

  /// Passes the time t of a kink; `before` is just before t. Returns whether velocities jumped
  /// (discontinuities.hpp). Throws a ModelError.
  bool pass_discontinuity(const S& before, const S& t, StateVector& y) {
    ++events_;
    if (!account_.has_drivers()) return false;
    load(y);
    auto impulse = trivium::pass_discontinuity(layout_, state_, solver_, projection_, account_, before, t, y);
    if (impulse) log_.add(std::move(*impulse));
    return impulse.has_value();
  }

  /// The acceleration solver with its refined solution at (t, y).
  AccelerationSolver<F>& solved(const S& t, const StateVector& y) {
    if (!is_solved(t, y)) {
      solve_as(t, y, Refinement::as_needed, DependentRows::keep);
      solved_t_ = t;
      solved_ = y;
    }
    return solver_;
  }
  MechanismState<S> to_mechanism_state(const S& t, const StateVector& y) {
    load(y);
    MechanismState<S> state{t, {}, {}};
    for (const BodyState<F>& body : state_) {
      Vector4<S> p = F::to_euler_parameters(body.chart, body.q);
      state.pose.push_back({body.r, p / p.norm()});
      state.twist.push_back({body.r_dot, kinematics_of(body).omega_bar});
    }
    return state;
  }
  /// Largest | |p|^2 - 1 | of the bodies [-]; 0 in formulations without internal rows.
  S normalisation_violation(const StateVector& y) const {
    S largest(0);
    if constexpr (F::internal_constraints > 0)
      for (int b = 0; b < nb(); ++b) {
        using std::abs;
        raise(largest, S(abs(layout_.orientation(y, b).squaredNorm() - S(1))));
      }
    return largest;
  }
  MotionEnergy<S> energy(const S& t, const StateVector& y) {
    move_bodies(t, y);
    MotionEnergy<S> energy = account_.energy(view(t));
    if (does_work()) energy.work = y[motion_size()];
    return energy;
  }

  /// Sum of m v^2 / 2 over the bodies, v the fastest speed so far in the body's group of connected bodies
  /// [J].
  S fastest_energy() const {
    S twice(0);
    for (int b = 0; b < nb(); ++b)
      twice += mechanism_.bodies[b].mass * measure().fastest_of(b) * measure().fastest_of(b);
    return twice / 2;
  }

  // messages about failed steps (diagnosis.hpp)
  std::string diagnose(const S& t, const StateVector& y, const S& step) {
    move_bodies(t, y);
    return trivium::diagnose<F>(mechanism_, account_.drivers(), start_of_motion_, state_, view(t),
                                to_mechanism_state(t, y), step);
  }
  std::string excessive_load(const S& t, const StateVector& y) {
    move_bodies(t, y);
    return trivium::excessive_load(mechanism_.effects, view(t));
  }
  /// The body with the largest acceleration at (t, y) or a moment later.
  std::string most_accelerated(const S& t, const StateVector& y) {
    using std::abs;
    std::string clause;
    // a load that changes within any step may vanish at t
    for (const S& at : {t, S(t + S(1e-12) * std::max(S(1), S(abs(t))))}) {
      solve(at, y);
      take_motion();
      const std::string body = trivium::most_accelerated(mechanism_, solver_, view(at));
      if (!body.empty()) clause = body;
    }
    return clause;
  }
  /// The sizes of all loads on each body at the state of the last evaluation and time t, cancelled by none.
  std::vector<Wrench<S>> load_sizes(const S& t) {
    take_motion();
    return trivium::load_sizes(mechanism_.effects, view(t));
  }
  /// A message about a body near the singularity of its chart; empty if there is none.
  std::string near_singular_chart(const S& t, const StateVector& y) {
    load(y);
    return trivium::near_singular_chart<F>(mechanism_, state_, t, S(reframing_distance));
  }

  const MechanismOf<F>& mechanism() const { return mechanism_; }
  bool does_work() const { return account_.does_work(); }
  const std::vector<BodyState<F>>& state() const { return state_; }
  long factorisations() const { return factorisations_ + projection_.factorisations(); }
  int reframings() const { return charts_.changes(); }
  /// The kinks passed so far; after each the motion begins anew.
  long events() const { return events_; }
  const MotionLog<S>& log() const { return log_; }

  // saved runs
  /// The state from which a later run continues with the same numbers.
  SavedRun save(const StateVector& y) {
    SavedRun saved;
    saved.formulation = F::name;
    const VectorX<double> numbers = scalar_cast<double>(y);
    saved.y.assign(numbers.begin(), numbers.end());
    saved.began_singular = detection_ == DependentRows::detect;
    saved.fastest = projection_.measure().fastest();
    saved.charts = charts();
    saved.angles = counted_angles();
    return saved;
  }
  /// The name of every body's chart; empty in formulations without charts.
  std::vector<std::string> charts() const { return chart_names(state_); }
  /// The joint angles that effects counted last [rad] (saved_numbers.hpp).
  std::vector<double> counted_angles() { return trivium::counted_angles(mechanism_); }
  /// The joint angles of effects at (t, y) [rad].
  std::vector<double> joint_angles(const S& t, const StateVector& y) {
    move_bodies(t, y);
    std::vector<double> angles;
    mechanism_.effects.for_each_angle(
        [&](const JointAngle<S>& angle) { angles.push_back(static_cast<double>(angle.value(view(t)))); });
    return angles;
  }

  // for ConstrainedEquations, which shares the bodies
  AccelerationSolver<F>& solver() { return solver_; }
  const EnergyAccount<S, MechanismTypesOf<F>>& account() const { return account_; }
  /// The measure of violations, with the fastest speeds of the accepted states.
  const ConstraintViolation<S>& measure() const { return projection_.measure(); }
  /// Moves the bodies to y.
  void load(const StateVector& y) {
    if (solved_t_ && solved_ != y) solved_t_.reset();  // the solution no longer belongs to the bodies
    measured_ = Rows::none;
    layout_.load(y, state_);
  }

 private:
  enum class Rows { none, positions, velocities };

  /// Moves the bodies to y to measure rows, and remembers the state: a correction need not measure it again.
  void move_to(const S& t, const StateVector& y, Rows rows) {
    load(y);
    projection_.move(state_, t);
    measured_ = rows;
    measured_t_ = t;
    measured_y_ = y;
  }
  bool is_measured(const S& t, const StateVector& y, Rows rows) const {
    return measured_ == rows && measured_t_ == t && measured_y_ == y;
  }
  bool is_solved(const S& t, const StateVector& y) const {
    return solved_t_ && *solved_t_ == t && solved_ == y;
  }
  void solve(const S& t, const StateVector& y) {
    if (!is_solved(t, y))
      solve_as(t, y, refines_ ? Refinement::as_needed : Refinement::none, DependentRows::keep);
  }
  void solve_as(const S& t, const StateVector& y, Refinement refinement, DependentRows how) {
    solved_t_.reset();
    load(y);
    ++factorisations_;
    solver_.solve(state_, t, refinement, how);
  }

  /// Whether the last solution takes a row for nearly dependent because a body is light: a pivot is weighted
  /// by inertia, and falls with the mass of a body between heavy ones. At a singular position geometry alone
  /// says the same. Geometry is asked if more rows are dependent than at any accepted state before.
  bool leaves_out_rows_of_light_bodies() {
    if (detection_ != DependentRows::detect_near_singular) return false;
    const int found = solver_.factors().dependent_row_count();
    if (found > fewest_dependent_rows_ && solver_.weak_rows_by_geometry() < found) return true;
    fewest_dependent_rows_ = std::min(found, fewest_dependent_rows_);
    return false;
  }

  /// Accepts the start of a motion. Throws a ModelError.
  void begin(const MechanismState<S>& start, bool is_projected);

  /// Continues a saved run. Throws an Error of kind input if its numbers do not belong to the given state.
  void go_on_from(const SavedRun& saved, const MechanismState<S>& state, bool is_projected);

  bool reframe(const S& t, StateVector& y) {
    load(y);
    return charts_.change(mechanism_, t, layout_, state_, y);
  }

  /// Moves the bodies to y, and copies their motion for the effects.
  void move_bodies(const S& t, const StateVector& y) {
    load(y);
    projection_.move(state_, t);
    take_motion();
  }
  /// Copies the motion of the bodies, as they were moved last, for the effects.
  void take_motion() {
    std::copy(solver_.assembly().body().begin(), solver_.assembly().body().end(), motion_.begin());
  }
  EffectView<S> view(const S& t) const { return {mechanism_.bodies, motion_, t}; }

  MechanismOf<F> mechanism_;  ///< a copy, because its effects count turns
  const StateLayout<F> layout_;
  AccelerationSolver<F> solver_;
  std::vector<BodyState<F>> state_;
  std::vector<BodyMotion<S>> motion_;
  ConstraintProjection<F> projection_;
  EnergyAccount<S, MechanismTypesOf<F>> account_;
  ChartSwitching<F> charts_;
  BranchCheck<F> branches_;
  DeadPoints<S> dead_points_;
  MotionLog<S> log_;
  long events_ = 0;
  VectorX<S> lambda_;
  bool limits_steps_ = false;
  StateVector start_;
  StartOfMotion<S> start_of_motion_;
  /// If refinement at the last accepted state corrected the accelerations by this relative amount or less,
  /// solutions between accepted states are not refined: their errors are then far below those of a step.
  /// 1e-13 is about 1000 u of double, and is used in quad too: solutions between accepted states may have
  /// errors up to 1e-13, although their rounding is near 1e-34.
  static constexpr double small_correction = 1e-13;
  // the state whose refined solution the solver holds, if any, and whether solutions between accepted states
  // are refined
  std::optional<S> solved_t_;
  StateVector solved_;
  bool refines_ = false;
  // the state at which rows were measured last, and whether they were rows of positions or of velocities
  Rows measured_ = Rows::none;
  S measured_t_{0};
  StateVector measured_y_;
  DependentRows detection_ = DependentRows::detect;  ///< how accepted states detect dependent rows
  int fewest_dependent_rows_ = 0;                    ///< of the accepted states
  long factorisations_ = 0;
};

template <Formulation F>
void FirstOrderEquations<F>::begin(const MechanismState<S>& start, bool is_projected) {
  try {
    accept_state(start.t, start_);
  } catch (const ModelError& error) {
    const std::string cause = near_singular_chart(start.t, start_);
    if (cause.empty()) throw;
    throw ModelError(Place{}, cause);
  }
  // The strict detection (`detect`) has just counted the dependent rows of the start. A projected motion
  // also treats nearly dependent rows as dependent, since it may pass a singular position. If this changes
  // the number of dependent rows already at the start, the strict detection is used along the whole motion.
  // Without projection the constraints drift, so that dependent rows look independent: such a motion keeps
  // the number of dependent rows of its start.
  const int found = solver_.factors().dependent_row_count();
  detection_ = is_projected ? DependentRows::detect_near_singular : DependentRows::keep_count;
  fewest_dependent_rows_ = found;
  log_.begin();
  accept_state(start.t, start_);
  if (solver_.factors().dependent_row_count() == found) return;
  detection_ = DependentRows::detect;
  log_.begin();
  accept_state(start.t, start_);
}

template <Formulation F>
void FirstOrderEquations<F>::go_on_from(const SavedRun& saved, const MechanismState<S>& state,
                                        bool is_projected) {
  start_ = restore_numbers(saved, mechanism_, state, size(), state_, projection_);
  check_bodies_as_saved(saved, mechanism_, state, to_mechanism_state(state.t, start_));
  // positions and velocities may violate their rows by the method's error; with the strict detection,
  // redundant rows would then look independent
  detection_ = saved.began_singular ? DependentRows::detect : DependentRows::detect_near_singular;
  log_.begin();
  accept_state(state.t, start_);
  if (!is_projected) detection_ = DependentRows::keep_count;
}

}  // namespace trivium
