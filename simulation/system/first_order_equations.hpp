#pragma once
/// The equations of motion of one formulation as y' = f(t, y), index 1, as libraries for ordinary
/// differential equations take them. y is laid out as state_layout.hpp says. The parts stand beside this
/// file: projection and violation of constraints, energy, charts, jumps of velocities, the check for other
/// branches, the log.
///
/// Decided here: which rows count as dependent along a motion (anew at every state that it reaches, in the
/// way that is chosen once, at its start), and whether solutions are refined between those states.
///
/// Models integrators' FirstOrderSystem.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "mechanism/saved_run.hpp"
#include "simulation/system/branch_check.hpp"
#include "simulation/system/chart_switching.hpp"
#include "simulation/system/constraint_projection.hpp"
#include "simulation/system/discontinuities.hpp"
#include "simulation/system/energy_account.hpp"
#include "simulation/system/motion_log.hpp"
#include "simulation/system/state_layout.hpp"

namespace trivium {

struct FirstOrderOptions {
  ChartOptions charts;
  std::optional<Baumgarte> baumgarte;
  bool is_projected = true;        ///< after every step; if not, violations hide which rows depend on others
  const SavedRun* from = nullptr;  ///< of this formulation, at the start: its numbers are gone on with

  /// Of the first run, by which the scales of rows are [s].
  template <class S>
  S first_start(const S& t) const {
    return from ? S(from->start) : t;
  }
};

template <Formulation F>
class FirstOrderEquations {
 public:
  using Scalar = typename F::Scalar;
  using S = Scalar;
  using StateVector = VectorX<S>;

  /// Throws a ModelError that names the body whose chart is singular.
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
        lambda_(mechanism_.nc()) {
    if (options.baumgarte) solver_.stabilise(*options.baumgarte);
    limits_steps_ = mechanism_.effects.limit_steps();
    start_ = StateVector::Zero(size());
    for (int b = 0; b < nb(); ++b) {
      layout_.place(start_, b) << state_[b].r, F::orientation_of(state_[b].chart, start.pose[b].p);
      layout_.rate(start_, b) << state_[b].r_dot, F::velocity_of(state_[b].chart, state_[b].q);
    }
    if (options.from) {
      go_on_from(*options.from, start, options.is_projected);
      return;
    }
    accept_state(start.t, start_);
    // a motion may pass positions where rows are nearly dependent; one that starts there lives with them
    const int found = solver_.factors().dependent_row_count();
    detection_ = options.is_projected ? DependentRows::detect_near_singular : DependentRows::keep_count;
    log_.begin();
    accept_state(start.t, start_);
    if (solver_.factors().dependent_row_count() == found) return;
    detection_ = DependentRows::detect;
    log_.begin();
    accept_state(start.t, start_);
  }

  int nb() const { return mechanism_.nb(); }
  int size() const { return motion_size() + (does_work() ? 1 : 0); }
  /// Without the work.
  int motion_size() const { return layout_.motion_size(); }
  const StateLayout<F>& layout() const { return layout_; }
  const StateVector& start() const { return start_; }

  /// y' at (t, y). Throws a ModelError.
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

  // the constraints: how far y is from them, and one step of the way back
  integrators::Violation<S> position_violation(const S& t, const StateVector& y) {
    move_to(t, y, Rows::positions);
    return projection_.measure_positions();
  }
  integrators::Violation<S> velocity_violation(const S& t, const StateVector& y) {
    move_to(t, y, Rows::velocities);
    return projection_.measure_velocities();
  }
  /// Whether a projection went so far that it may have left the branch of the motion (branch_check.hpp).
  bool projection_is_too_large(const StateVector& before, const StateVector& stepped,
                               const StateVector& projected) {
    return branches_.projection_is_too_large(layout_, projection_.measure(), before, stepped, projected);
  }
  /// The longest step [s] from here, after which turns are still counted.
  S longest_step(const S& t, const StateVector& y) {
    if (!limits_steps_) return std::numeric_limits<S>::max();
    load(y);
    projection_.move(state_, t);
    take_motion();
    return mechanism_.effects.longest_step(view(t));
  }
  const std::string& row_name(int row) const { return projection_.measure().row_name(row); }
  /// One step back; the matrix is factored where asked, else it is that of before.
  void correct_positions(const S& t, StateVector& y, bool factor) {
    if (!is_measured(t, y, Rows::positions)) position_violation(t, y);
    projection_.correct_positions(layout_, state_, y, factor);
  }
  void correct_velocities(const S& t, StateVector& y, bool factor) {
    if (!is_measured(t, y, Rows::velocities)) velocity_violation(t, y);
    projection_.correct_velocities(layout_, state_, y, factor);
  }
  /// The same for the rows that a formulation has of its own: normalisation.
  void normalise(StateVector& y) const {
    for (int b = 0; b < nb(); ++b) {
      typename F::Orientation x = layout_.orientation(y, b);
      typename F::Unknown v = layout_.velocity(y, b);
      F::normalise(x, v);
      layout_.place(y, b).tail(F::orientation_size) = x;
      layout_.rate(y, b).tail(F::rotational_unknowns) = v;
    }
  }

  /// At a state that the motion has reached: bodies near their chart's singularity change it, which rows
  /// depend on others is found, and turns are counted. Returns whether y is in other coordinates now. Throws
  /// a ModelError.
  bool accept_state(const S& t, StateVector& y) {
    accepted_t_.reset();
    const bool reframed = charts_.is_on() && reframe(t, y);
    solve_as(t, y, Refinement::as_needed, detection_);
    log_.note_dependent_rows(t, solver_.factors().dependent_row_count());
    refines_ = !(solver_.corrections().acceleration <= small_correction);
    accepted_t_ = t;
    accepted_ = y;
    projection_.accept_state();
    take_motion();
    mechanism_.effects.follow(view(t));
    return reframed;
  }

  /// Over a time where functions may jump, from just before it. Returns whether velocities jumped. Throws a
  /// ModelError.
  bool pass_discontinuity(const S& before, const S& t, StateVector& y) {
    if (!account_.has_drivers()) return false;
    load(y);
    auto impulse = trivium::pass_discontinuity(layout_, state_, solver_, projection_, account_, before, t, y);
    if (impulse) log_.add(std::move(*impulse));
    return impulse.has_value();
  }

  /// The solver, solved and refined at (t, y).
  AccelerationSolver<F>& solved(const S& t, const StateVector& y) {
    if (!is_accepted(t, y)) solve_as(t, y, Refinement::as_needed, DependentRows::keep);
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
  /// Largest | |p|^2 - 1 | of the numbers as they are; 0 where there is no such row.
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
    load(y);
    projection_.move(state_, t);
    take_motion();
    MotionEnergy<S> energy = account_.energy(view(t));
    if (does_work()) energy.work = y[motion_size()];
    return energy;
  }

  /// What of the model may have made an integrator fail at y, or near it; empty where nothing stands out.
  std::string diagnose(const S& t, const StateVector& y) {
    load(y);
    return charts_.near_singularity(mechanism_, state_, t);
  }

  const MechanismOf<F>& mechanism() const { return mechanism_; }
  bool does_work() const { return account_.does_work(); }
  const std::vector<BodyState<F>>& state() const { return state_; }
  long factorisations() const { return factorisations_ + projection_.factorisations(); }
  int reframings() const { return charts_.changes(); }
  const MotionLog<S>& log() const { return log_; }

  // to go on later, in the same numbers
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
  /// Per body; none in formulations without.
  std::vector<std::string> charts() const {
    std::vector<std::string> names;
    for (const BodyState<F>& body : state_)
      if (const std::string chart(body.chart.name()); !chart.empty()) names.push_back(chart);
    return names;
  }
  /// Where effects counted joint angles last [rad], effect by effect.
  std::vector<double> counted_angles() {
    std::vector<double> angles;
    mechanism_.effects.for_each_angle(
        [&](const JointAngle<S>& angle) { angles.push_back(static_cast<double>(angle.tracked)); });
    return angles;
  }
  /// The angles of joints that effects count [rad], effect by effect.
  std::vector<double> joint_angles(const S& t, const StateVector& y) {
    load(y);
    projection_.move(state_, t);
    take_motion();
    std::vector<double> angles;
    mechanism_.effects.for_each_angle(
        [&](const JointAngle<S>& angle) { angles.push_back(static_cast<double>(angle.value(view(t)))); });
    return angles;
  }

  // for the equations with constraints, which speak of the same bodies
  AccelerationSolver<F>& solver() { return solver_; }
  const EnergyAccount<S, MechanismTypesOf<F>>& account() const { return account_; }
  /// Moves the bodies to y.
  void load(const StateVector& y) {
    if (accepted_t_ && accepted_ != y) accepted_t_.reset();  // its bodies move on
    measured_ = Rows::none;
    layout_.load(y, state_);
  }

 private:
  enum class Rows { none, positions, velocities };

  /// To measure rows there; a correction of the same state then has nothing to measure.
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
  bool is_accepted(const S& t, const StateVector& y) const {
    return accepted_t_ && *accepted_t_ == t && accepted_ == y;
  }
  void solve(const S& t, const StateVector& y) {
    if (!is_accepted(t, y))
      solve_as(t, y, refines_ ? Refinement::as_needed : Refinement::none, DependentRows::keep);
  }
  void solve_as(const S& t, const StateVector& y, Refinement refinement, DependentRows how) {
    accepted_t_.reset();
    load(y);
    ++factorisations_;
    solver_.solve(state_, t, refinement, how);
  }

  /// Takes the numbers of a saved run, which must be those of the state.
  void go_on_from(const SavedRun& saved, const MechanismState<S>& state, bool is_projected);

  bool reframe(const S& t, StateVector& y) {
    load(y);
    return charts_.change(mechanism_, t, layout_, state_, y);
  }

  /// Of the bodies as they were moved last.
  void take_motion() {
    std::copy(solver_.assembly().body().begin(), solver_.assembly().body().end(), motion_.begin());
  }
  EffectView<S> view(const S& t) const { return {mechanism_.bodies, motion_, t}; }

  MechanismOf<F> mechanism_;  ///< its effects count turns
  const StateLayout<F> layout_;
  AccelerationSolver<F> solver_;
  std::vector<BodyState<F>> state_;
  std::vector<BodyMotion<S>> motion_;
  ConstraintProjection<F> projection_;
  EnergyAccount<S, MechanismTypesOf<F>> account_;
  ChartSwitching<F> charts_;
  BranchCheck<F> branches_;
  MotionLog<S> log_;
  VectorX<S> lambda_;
  bool limits_steps_ = false;
  StateVector start_;
  /// A relative correction of accelerations by refinement up to which solutions between accepted states are
  /// not refined: it leaves errors far below those of a step.
  static constexpr double small_correction = 1e-13;
  // of the state accepted last
  std::optional<S> accepted_t_;
  StateVector accepted_;
  bool refines_ = false;
  // whose rows the projection has, and where
  Rows measured_ = Rows::none;
  S measured_t_{0};
  StateVector measured_y_;
  DependentRows detection_ = DependentRows::detect;  ///< how dependent rows are found at accepted states
  long factorisations_ = 0;
};

template <Formulation F>
void FirstOrderEquations<F>::go_on_from(const SavedRun& saved, const MechanismState<S>& state,
                                        bool is_projected) {
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorKind::input, {mechanism_.name, saved.t},
                fmt::format("the saved run cannot be continued: {}; leave out the key \"saved\" to start a "
                            "new run from the state of the bodies",
                            why));
  };
  if (static_cast<double>(state.t) != saved.t)
    refuse(fmt::format("the state is requested at t = {}", static_cast<double>(state.t)));
  if (static_cast<int>(saved.y.size()) != size())
    refuse(fmt::format("y has {} entries, but a state of {} bodies in {} has {}", saved.y.size(), nb(),
                       F::name, size()));
  for (int b = 0; b < nb(); ++b) {
    const std::string chart = saved.charts.empty() ? std::string() : saved.charts[b];
    bool is_known = false;
    if constexpr (requires { read_chart(chart, state_[b].chart); })
      is_known = read_chart(chart, state_[b].chart);
    if (!is_known) refuse(fmt::format("{} cannot restore a chart from the name \"{}\"", F::name, chart));
  }
  std::size_t counted = 0;
  mechanism_.effects.for_each_angle([&](JointAngle<S>& angle) {
    if (counted < saved.angles.size()) angle.tracked = S(saved.angles[counted]);
    ++counted;
  });
  if (counted != saved.angles.size())
    refuse(fmt::format("the effects track {} angles, the saved run has {}", counted, saved.angles.size()));
  if (!projection_.measure().set_fastest(saved.fastest))
    refuse(fmt::format("the number of entries of \"fastest\", {}, does not fit the mechanism",
                       saved.fastest.size()));
  for (int k = 0; k < size(); ++k) start_[k] = S(saved.y[k]);
  // whoever moved a body by hand means the body
  const MechanismState<S> at = to_mechanism_state(state.t, start_);
  for (int b = 0; b < nb(); ++b) {
    const Pose<S>&pose = state.pose[b], &kept = at.pose[b];
    const Twist<S>&twist = state.twist[b], &kept_twist = at.twist[b];
    const auto is_near = [](const auto& x, const auto& y) {
      return S((x - y).norm()) <= S(1e-12) * S(x.norm());
    };
    if (!(is_near(pose.r, kept.r) && is_near(pose.p, kept.p) && is_near(twist.r_dot, kept_twist.r_dot) &&
          is_near(twist.omega_bar, kept_twist.omega_bar)))
      refuse(fmt::format("position or velocity of body \"{}\" differs from the saved state",
                         mechanism_.body_names[b]));
  }
  // the state may miss its rows by the method's error, which hides what depends on others from a strict look
  detection_ = saved.began_singular ? DependentRows::detect : DependentRows::detect_near_singular;
  log_.begin();
  accept_state(state.t, start_);
  if (!is_projected) detection_ = DependentRows::keep_count;
}

}  // namespace trivium
