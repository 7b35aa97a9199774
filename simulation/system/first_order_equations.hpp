#pragma once
/// The equations of motion of one formulation as y' = f(t, y) in flat numbers, index 1: what libraries for
/// ordinary differential equations take. Positions of all bodies first (r, then the orientation in the
/// formulation's own numbers), then their velocities, and the work done on the mechanism where any is done.
///
/// Models integrators' FirstOrderSystem.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "constraints/constraint_row.hpp"
#include "formulations/euler_chart.hpp"
#include "simulation/system/constraint_projection.hpp"
#include "simulation/system/motion_log.hpp"

namespace trivium {

struct FirstOrderOptions {
  ChartOptions charts;
  std::optional<Baumgarte> baumgarte;
  bool is_projected = true;  ///< after every step; if not, violations hide which rows depend on others
};

/// [J]
template <class S>
struct MotionEnergy {
  S kinetic{0}, potential{0};
  S total() const { return kinetic + potential; }
  S work{0};  ///< since the start, of drivers and of what effects do not take from stored energy
};

template <Formulation F>
class FirstOrderEquations {
 public:
  using Scalar = typename F::Scalar;
  using S = Scalar;
  using StateVector = VectorX<S>;

  /// Numbers of a body in the positions and in the velocities.
  static constexpr int positions = 3 + F::orientation_size, velocities = 3 + F::rotational_unknowns;
  using Velocity = Vector<S, velocities>;

  /// Throws a ModelError that names the body whose chart is singular.
  FirstOrderEquations(const Mechanism<S>& mechanism, const MechanismState<S>& start,
                      const FirstOrderOptions& options = {})
      : mechanism_(mechanism),
        solver_(mechanism_),
        state_(to_coordinates<F>(mechanism_, start, options.charts)),
        motion_(mechanism_.nb() + 1),
        projection_(solver_, start.t),
        charts_(options.charts),
        lambda_(mechanism_.nc()) {
    if (options.baumgarte) solver_.stabilise(*options.baumgarte);
    for (int k = 0; k < mechanism_.nc(); ++k)
      if (!function_of(mechanism_.rows[k]).is_constant()) drivers_.push_back(k);
    does_work_ = !drivers_.empty() || !mechanism_.effects.are_conservative();
    counts_turns_ = !mechanism_.effects.template all<TorsionalSpringDamper<S>>().empty();
    way_.resize(mechanism_.nb() + 1);
    start_ = StateVector::Zero(size());
    for (int b = 0; b < nb(); ++b) {
      place(start_, b) << state_[b].r, F::orientation_of(state_[b].chart, start.pose[b].p);
      rate(start_, b) << state_[b].r_dot, F::velocity_of(state_[b].chart, state_[b].q);
    }
    accept_state(start.t, start_);
    // a motion may pass positions where rows are nearly dependent; one that starts there lives with them
    const int found = solver_.factors().dependent_row_count();
    settles_by_ = options.is_projected ? DependentRows::detect_near_singular : DependentRows::keep_count;
    left_out_ = -1;
    accept_state(start.t, start_);
    if (solver_.factors().dependent_row_count() == found) return;
    settles_by_ = DependentRows::detect;
    left_out_ = -1;
    accept_state(start.t, start_);
  }

  int nb() const { return mechanism_.nb(); }
  int size() const { return motion_size() + (does_work_ ? 1 : 0); }
  /// Without the work.
  int motion_size() const { return (positions + velocities) * nb(); }
  const StateVector& start() const { return start_; }

  /// y' at (t, y). Throws a ModelError.
  void derivative(const S& t, const StateVector& y, StateVector& y_dot) {
    solve(t, y);
    y_dot.resize(size());
    for (int b = 0; b < nb(); ++b) {
      const BodyState<F>& body = state_[b];
      place(y_dot, b) << body.r_dot, F::orientation_rate(body.chart, flat(y, b), velocity_of(y, b));
      rate(y_dot, b) << solver_.r_ddot(b), solver_.q_ddot(b);
    }
    if (!does_work_) return;
    solver_.copy_lambda(lambda_);
    y_dot[motion_size()] = power(solver_.assembly().body(), lambda_, t);
  }

  // the constraints: how far y is from them, and one step of the way back
  S position_violation(const S& t, const StateVector& y) {
    load(y);
    projection_.move(state_, t);
    return projection_.measure_positions();
  }
  S velocity_violation(const S& t, const StateVector& y) {
    load(y);
    projection_.move(state_, t);
    return projection_.measure_velocities();
  }
  /// Of the violation measured last, beside the lengths or speeds of what moves together.
  const S& relative_violation() const { return projection_.measure().relative(); }
  /// Whether a projection moved some assembly by more than a tenth of what the step did, and more than a
  /// little: the step may have left its branch. checked_step of integrators/integrate.cpp then takes it back
  /// and has the method take a shorter one.
  bool projection_is_too_large(const StateVector& before, const StateVector& stepped,
                               const StateVector& projected) {
    const auto exceeds = [&](int first, int width, const S& little) {
      for (Way& way : way_) way = {};
      for (int b = 0; b < nb(); ++b) {
        Way& way = way_[projection_.measure().component_of(b)];
        const int at = first + width * b;
        way.back += (projected.segment(at, width) - stepped.segment(at, width)).squaredNorm();
        way.step += (stepped.segment(at, width) - before.segment(at, width)).squaredNorm();
        way.size += stepped.segment(at, width).squaredNorm();
      }
      using std::sqrt;
      return std::any_of(way_.begin(), way_.end(), [&](const Way& way) {
        return !(sqrt(way.back) <= sqrt(way.step) / 10 + little * sqrt(way.size));
      });
    };
    // another branch of velocities is as far as they are large
    return exceeds(0, positions, S(1e-4)) || exceeds(positions * nb(), velocities, S(1e-2));
  }
  /// The longest step [s] from here, after which turns are still counted.
  S longest_step(const S& t, const StateVector& y) {
    if (!counts_turns_) return std::numeric_limits<S>::max();
    load(y);
    projection_.move(state_, t);
    take_motion();
    return mechanism_.effects.longest_step(view(t));
  }
  const std::string& worst_row() const { return projection_.measure().worst_row(); }
  /// Of what was measured last; the matrix is factored where asked, else it is that of before.
  void correct_positions(StateVector& y, bool factor) {
    if (factor) projection_.factor();
    projection_.solve();
    for (int b = 0; b < nb(); ++b) {
      place(y, b) << state_[b].r + projection_.r_change(b),
          F::retract(state_[b].chart, flat(y, b), projection_.q_change(b));
    }
  }
  void correct_velocities(StateVector& y, bool factor) {
    if (factor) projection_.factor();
    projection_.solve();
    for (int b = 0; b < nb(); ++b) {
      typename F::Unknown v = velocity_of(y, b) + projection_.q_change(b);
      rate(y, b) << state_[b].r_dot + projection_.r_change(b), v;
    }
  }
  /// The same for the rows that a formulation has of its own: normalisation.
  void normalise(StateVector& y) const {
    for (int b = 0; b < nb(); ++b) {
      typename F::Orientation x = flat(y, b);
      typename F::Unknown v = velocity_of(y, b);
      F::normalise(x, v);
      place(y, b).tail(F::orientation_size) = x;
      rate(y, b).tail(F::rotational_unknowns) = v;
    }
  }

  /// At a state that the motion has reached: bodies near their chart's singularity change it, which rows
  /// depend on others is found, and turns are counted. Returns whether y is in other coordinates now. Throws
  /// a ModelError.
  bool accept_state(const S& t, StateVector& y) {
    settled_t_.reset();
    const bool reframed = charts_.reframe && reframe(y);
    solve_as(t, y, Refinement::as_needed, settles_by_);
    note_passage(t);
    refines_ = !(solver_.corrections().acceleration <= 1e-13);
    settled_t_ = t;
    settled_ = y;
    projection_.accept_state();
    take_motion();
    mechanism_.effects.follow(view(t));
    return reframed;
  }

  /// Over a time where functions may jump, from just before it: where the rows ask for other velocities from
  /// there on, an impulse gives them to the bodies,
  ///
  ///   M dv + Phi_q^T Lambda = 0,   Phi_q dv = jump of nu
  ///
  /// and does -Lambda . (nu before + nu after) / 2 of work. Returns whether there was one. Throws a
  /// ModelError.
  bool pass_discontinuity(const S& before, const S& t, StateVector& y) {
    if (drivers_.empty()) return false;
    load(y);
    projection_.move(state_, t);
    projection_.measure_jump(before);
    if (!(projection_.measure().relative() > S(1e-9))) return false;
    correct_velocities(y, true);
    Impulse<S> impulse{static_cast<double>(t), VectorX<S>(mechanism_.nc())};
    projection_.copy_multipliers(impulse.lambda);
    const auto& body = solver_.assembly().body();
    y[motion_size()] +=
        (drivers_power(body, impulse.lambda, before) + drivers_power(body, impulse.lambda, t)) / 2;
    impulses_.push_back(std::move(impulse));
    return true;
  }

  /// The solver, solved and refined at (t, y).
  AccelerationSolver<F>& solved(const S& t, const StateVector& y) {
    if (!is_settled(t, y)) solve_as(t, y, Refinement::as_needed, DependentRows::keep);
    return solver_;
  }
  MechanismState<S> to_mechanism_state(const S& t, const StateVector& y) {
    load(y);
    MechanismState<S> state{t, {}, {}};
    for (const BodyState<F>& body : state_) {
      Vector4<S> p = F::to_euler_parameters(body.chart, body.q);
      state.pose.push_back({body.r, p / p.norm()});
      state.twist.push_back({body.r_dot, F::kinematics(body.chart, body.r, body.r_dot, body.q).omega_bar});
    }
    return state;
  }
  /// Largest | |p|^2 - 1 | of the numbers as they are; 0 where there is no such row.
  S normalisation_violation(const StateVector& y) const {
    S largest(0);
    if constexpr (F::internal_constraints > 0)
      for (int b = 0; b < nb(); ++b) {
        using std::abs;
        largest = std::max(largest, S(abs(flat(y, b).squaredNorm() - S(1))));
      }
    return largest;
  }
  MotionEnergy<S> energy(const S& t, const StateVector& y) {
    load(y);
    projection_.move(state_, t);
    take_motion();
    MotionEnergy<S> energy;
    for (int b = 0; b < nb(); ++b)
      energy.kinetic +=
          kinetic_energy(mechanism_.bodies[b], Twist<S>{motion_[b].r_dot, motion_[b].omega_bar});
    energy.potential = mechanism_.effects.potential_energy(view(t));
    if (does_work_) energy.work = y[motion_size()];
    return energy;
  }

  /// What of the model may have made an integrator fail at y, or near it; empty where nothing stands out.
  std::string diagnose(const S& t, const StateVector& y) {
    load(y);
    for (int b = 0; b < nb(); ++b) {
      const S distance = F::chart_distance(state_[b].chart, state_[b].q);
      if (distance < S(reframing_distance))
        return fmt::format(
            "body \"{}\" at t = {}: its Euler angles are {:.1e} from where they have no rates; leave "
            "re-framing on, or choose another sequence",
            mechanism_.body_names[b], static_cast<double>(t), static_cast<double>(distance));
    }
    return {};
  }
  const Mechanism<S>& mechanism() const { return mechanism_; }
  bool does_work() const { return does_work_; }
  const std::vector<BodyState<F>>& state() const { return state_; }
  long factorisations() const { return factorisations_ + projection_.factorisations(); }
  int reframings() const { return reframings_; }
  /// Positions passed where rows depended on others that do not elsewhere: the rows that were left out there
  /// say nothing then, and where a motion could go on in two ways it went as its velocities had it.
  const std::vector<SingularPassage>& passages() const { return passages_; }
  const std::vector<Impulse<S>>& impulses() const { return impulses_; }

 protected:
  auto place(StateVector& y, int b) const { return y.template segment<positions>(positions * b); }
  auto rate(StateVector& y, int b) const {
    return y.template segment<velocities>(positions * nb() + velocities * b);
  }
  typename F::Orientation flat(const StateVector& y, int b) const {
    return y.template segment<F::orientation_size>(positions * b + 3);
  }
  typename F::Unknown velocity_of(const StateVector& y, int b) const {
    return y.template segment<F::rotational_unknowns>(positions * nb() + velocities * b + 3);
  }

  void load(const StateVector& y) {
    if (settled_t_ && settled_ != y) settled_t_.reset();  // its bodies move on
    for (int b = 0; b < nb(); ++b) {
      state_[b].r = y.template segment<3>(positions * b);
      state_[b].r_dot = y.template segment<3>(positions * nb() + velocities * b);
      state_[b].q = F::from_orientation(state_[b].chart, flat(y, b), velocity_of(y, b));
    }
  }
  EffectView<S> view(const S& t) const { return {mechanism_.bodies, motion_, t}; }
  /// Of what effects do not take from stored energy, and of drivers: -lambda^T nu. Bodies with the ground
  /// last.
  template <class Body>
  S power(const std::vector<Body>& body, const VectorX<S>& lambda, const S& t) {
    std::copy(body.begin(), body.end(), motion_.begin());
    return mechanism_.effects.nonconservative_power(view(t)) + drivers_power(body, lambda, t);
  }

  Mechanism<S> mechanism_;  ///< its effects count turns
  AccelerationSolver<F> solver_;
  std::vector<BodyState<F>> state_;
  std::vector<BodyMotion<S>> motion_;

 private:
  bool is_settled(const S& t, const StateVector& y) const {
    return settled_t_ && *settled_t_ == t && settled_ == y;
  }
  void solve(const S& t, const StateVector& y) {
    if (!is_settled(t, y))
      solve_as(t, y, refines_ ? Refinement::as_needed : Refinement::none, DependentRows::keep);
  }
  void solve_as(const S& t, const StateVector& y, Refinement refinement, DependentRows how) {
    settled_t_.reset();
    load(y);
    ++factorisations_;
    solver_.solve(state_, t, refinement, how);
  }

  template <class Body>
  S drivers_power(const std::vector<Body>& body, const VectorX<S>& lambda, const S& t) const {
    S sum(0);
    for (const int k : drivers_) {
      const BodyPair pair = bodies_of(mechanism_.rows[k]);
      sum -= lambda[k] * evaluate_row(mechanism_.rows[k], body[pair.i], body[pair.j], t).nu;
    }
    return sum;
  }

  void note_passage(const S& t) {
    const int left_out = solver_.factors().dependent_row_count();
    if (left_out > left_out_ && left_out_ >= 0 && passages_.size() < most_passages)
      passages_.push_back({static_cast<double>(t), left_out - left_out_});
    left_out_ = left_out;
  }

  bool reframe(StateVector& y) {
    load(y);
    bool changed = false;
    for (int b = 0; b < nb(); ++b) {
      BodyState<F>& body = state_[b];
      if (!(F::chart_distance(body.chart, body.q) < S(reframing_distance))) continue;
      const Vector4<S> p = F::to_euler_parameters(body.chart, body.q);
      const Vector3<S> omega_bar = F::kinematics(body.chart, body.r, body.r_dot, body.q).omega_bar;
      body.chart = F::choose_chart(charts_, p);
      body.q = F::from_pose(body.chart, p, omega_bar);
      place(y, b).tail(F::orientation_size) = F::orientation_of(body.chart, p);
      rate(y, b).tail(F::rotational_unknowns) = F::velocity_of(body.chart, body.q);
      changed = true;
      ++reframings_;
    }
    return changed;
  }

  /// Of the bodies as they were moved last.
  void take_motion() {
    std::copy(solver_.assembly().body().begin(), solver_.assembly().body().end(), motion_.begin());
  }
  ConstraintProjection<F> projection_;
  ChartOptions charts_;
  VectorX<S> lambda_;
  std::vector<int> drivers_;  ///< rows that move by themselves
  bool does_work_ = false;
  bool counts_turns_ = false;
  /// Of an assembly, squares: how far a projection, a step moved it, and where it is.
  struct Way {
    S back{0}, step{0}, size{0};
  };
  std::vector<Way> way_;
  StateVector start_;
  // of the last settled state
  std::optional<S> settled_t_;
  StateVector settled_;
  bool refines_ = false;
  DependentRows settles_by_ = DependentRows::detect;
  int left_out_ = -1;  ///< rows
  static constexpr std::size_t most_passages = 1000;
  std::vector<SingularPassage> passages_;
  std::vector<Impulse<S>> impulses_;
  long factorisations_ = 0;
  int reframings_ = 0;
};

}  // namespace trivium
