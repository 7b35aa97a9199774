/// Walks over the stops of the grid. Each step to a stop is checked by checked_step, which repeats it shorter
/// if necessary; outputs within a step are interpolated.

#include "integrators/integrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "integrators/contract/errors.hpp"
#include "integrators/quad.hpp"
#include "integrators/step_size_control.hpp"

namespace trivium::integrators {

namespace {

/// What to try where a step of length `step` [s] from t failed whose start could be evaluated. Far-off stages
/// of an explicit method fail for strange reasons, such as a body without inertia. At late times the rounding
/// of times may be a part of each step. `step`: 0 if the method chooses it.
template <class S>
std::string advice_for(const std::string& message, const S& t, const S& step) {
  using std::abs;
  std::string advice;
  if (step != S(0) && message.find("smaller steps") == std::string::npos)
    advice = "; the step may be too long, since its start could be evaluated: take smaller steps";
  if (const S apart = std::numeric_limits<S>::epsilon() * abs(t); apart >= S(1e-12))
    advice += fmt::format(
        ". Times near {:g} are rounded by up to {:.1e} s, and so is every step: start nearer to t = 0",
        static_cast<double>(t), static_cast<double>(apart));
  return advice;
}

/// The message with a clause about a body, if there is one, in front of its last clause, the advice.
std::string with_body(std::string message, const std::string& clause) {
  const std::size_t advice = message.rfind("; ");
  return clause.empty() || advice == std::string::npos ? message : message.insert(advice, "; " + clause);
}

/// Calls `advance`, which moves (t, y) on. If it fails, the error gets the time of (t, y) unless it has one,
/// and the cause if the system knows it; the cause stands first, since the row or body that a method finds at
/// fault is often a neighbour. `step` is the length of the given step, or 0. `show` is called before the
/// error is thrown.
template <class S, class Advance, class Show>
void with_cause(AnySystem<S>& system, const S& t, const StateVector<S>& y, const S& step,
                const Advance& advance, const Show& show) {
  try {
    advance();
  } catch (const UsageError&) {
    throw;
  } catch (const std::runtime_error& error) {
    const auto* known = dynamic_cast<const Error*>(&error);
    const bool has_time = known && known->when() && std::isfinite(*known->when());
    const Place place{known ? known->where() : "", has_time ? known->when() : static_cast<double>(t)};
    std::string cause, body;
    try {
      cause = system.diagnose(t, y, step);
      // what is at fault in a stage far off may be a neighbour of the body that moves too fast; the rows that
      // end steps of chosen length are those of the state itself
      const bool names_a_body = place.where.find("body \"") != std::string::npos;
      if (cause.empty() && (place.where.empty() || names_a_body || step != S(0)))
        body = system.most_accelerated(t, y);
    } catch (const Error& at_state) {  // the state itself has no solution
      if (place.where.empty() && !at_state.where().empty()) cause = at_state.what();
    } catch (const std::runtime_error&) {  // not even that is known at this state
    }
    show();
    if (cause.empty())
      throw IntegrationError(with_body(error.what() + advice_for(error.what(), t, step), body), place);
    throw IntegrationError({{}, place.when},
                           cause + "; the method ended with: " + without_advice(error.what()));
  }
}

/// Takes one step from (t, y) = (before_t, before), at most to `stop`, and projects its end if `projects`. If
/// the step or its projection is not acceptable (see integrate.hpp), a shorter step is tried, if the method
/// can shorten its steps. A given step that is longer than the system's longest_step is an error; a chosen
/// one is shortened.
template <class S>
void checked_step(AnySystem<S>& system, AnyMethod<S>& method, const S& before_t, const StateVector<S>& before,
                  S& t, StateVector<S>& y, const S& stop, bool is_given, bool projects,
                  ProjectionIteration<AnySystem<S>>& project, ProjectionReport<S>& report) {
  const auto longest = system.longest_step(t, y);
  if (is_given && longest < stop - t && !is_same_length(longest, S(stop - t)))
    throw IntegrationError(
        {{}, static_cast<double>(t)},
        fmt::format("the given step of {:.4g} s is too long to count the turns of a torsional spring, whose "
                    "joint turns by one radian in {:.4g} s; take smaller steps, or control the step size by "
                    "tolerances",
                    static_cast<double>(S(stop - t)), static_cast<double>(longest)));
  const S limit = !is_given && longest < stop - t ? t + longest : stop;
  std::string trouble;
  for (;;) {
    try {
      method.step(system, t, y, limit);
    } catch (const UsageError&) {
      throw;
    } catch (const std::runtime_error& error) {
      if (trouble.empty()) throw;
      const auto* known = dynamic_cast<const Error*>(&error);
      throw IntegrationError(
          fmt::format("{}; an earlier, longer step failed because: {}", error.what(), trouble),
          known ? Place{known->where(), known->when()} : Place{});
    }
    const auto stepped = y;
    try {
      require_finite(y, t);
      // longest_step is the time for 1 rad of a spring's angle at the present rate. The step is at most as
      // long as this time at its start. If the rate has at most doubled, the angle moved by at most 2 rad and
      // its turns are still certain (effects/joint_angle.hpp).
      if (!(t - before_t <= 2 * system.longest_step(t, y)))
        throw IntegrationError({{}, static_cast<double>(t)},
                               "the step is too long to count the turns of a torsional spring; take smaller "
                               "steps, or control the step size by tolerances");
      if (!projects) return;
      const int row = project(system, t, y, report);
      if (!(project.drift() <= method.largest_drift()))
        throw IntegrationError(
            {fmt::format("row \"{}\"", system.row_name(row)), static_cast<double>(t)},
            "the step violates the constraints by far more than the tolerances; take tighter "
            "tolerances");
      if (!system.projection_is_too_large(before, stepped, y)) return;
      throw IntegrationError(
          {fmt::format("row \"{}\"", system.row_name(row)), static_cast<double>(t)},
          "the projection onto the constraints is larger than a tenth of the step, so the motion may have "
          "changed to another branch; take smaller steps, or control the step size by tolerances");
    } catch (const IntegrationError& error) {
      if (!method.shorten()) throw;
      trouble = error.what();
    }
    t = before_t;
    y = before;
  }
}

/// The outputs of a run. If the run fails, they end with the state that it has reached.
template <class S>
class Outputs {
 public:
  using Add = std::function<Continue(const S& t, const StateVector<S>& y)>;

  Outputs(const Add& add, AnyMethod<S>& method) : add_(add), method_(method) {}

  Continue add(const S& t, const StateVector<S>& y) {
    const Continue answer = add_(t, y);
    last_ = t;
    return answer;
  }
  /// Adds the state that a failed run has reached. If accelerations cannot be solved for there, as where an
  /// event has begun an infinite load, it adds the state just before the event.
  void add_reached(const S& t, const StateVector<S>& y) {
    if (!(last_ < t)) return;
    method_.restart();  // its lambda() may be that of the failed step
    try {
      add(t, y);
    } catch (const std::runtime_error&) {
      add_before_event();
    }
  }
  void add_before_event() {
    if (const auto before = std::exchange(before_event_, {})) add_reached(before->first, before->second);
  }
  /// An event begins. Afterwards coordinates may change: the state before it counts until the next step.
  void note_event(const S& t, const StateVector<S>& y) { before_event_.emplace(t, y); }
  void forget_event() { before_event_.reset(); }

 private:
  const Add& add_;
  AnyMethod<S>& method_;
  S last_ = std::numeric_limits<S>::lowest();
  std::optional<std::pair<S, StateVector<S>>> before_event_;
};

/// Ends a run that no longer gets on: 100 000 steps in a row have moved it by less than 1e-7 of its length.
/// At this rate it would take 1e12 steps, which is years.
template <class S>
class Progress {
 public:
  Progress(const S& t, const S& length) : since_(t), least_(S(1e-7) * length) {}

  void step(const S& t) {
    if (++steps_ < judged_steps) return;
    if (!(t - since_ >= least_))
      throw IntegrationError({{}, static_cast<double>(t)},
                             fmt::format("the run does not get on: its last {} steps have moved it by {:.2e} "
                                         "s; try other tolerances or another method",
                                         judged_steps, static_cast<double>(S(t - since_))));
    steps_ = 0;
    since_ = t;
  }

 private:
  static constexpr long judged_steps = 100000;
  S since_, least_;
  long steps_ = 0;
};

}  // namespace

template <class S>
bool integrate(AnySystem<S>& system, AnyMethod<S>& method, const TimeGrid& grid, bool projects,
               ProjectionReport<S>& report,
               const std::function<Continue(const S& t, const StateVector<S>& y)>& at_step,
               const std::function<Continue(const S& t, const StateVector<S>& y)>& at_output) {
  S t(grid.begin());
  StateVector<S> y = system.start(), before;
  ProjectionIteration<AnySystem<S>> project;
  if (projects && !grid.goes_on()) {
    ProjectionReport<S> of_the_start;  // not part of the report: the input may be given to fewer digits
    project(system, t, y, of_the_start);
    system.accept_state(t, y);
  }
  Outputs<S> outputs(at_output, method);
  if (outputs.add(t, y) == Continue::no) return false;
  // Steps of a method that interpolates pass outputs: `walk` goes ahead to the next event or the end, and
  // `due`, of a walk that follows, is the next output to be interpolated.
  TimeGrid::Walk<S> walk(grid), following(grid);
  std::optional<Stop<S>> due;
  if (method.interpolates()) due = following.next();
  using std::abs, std::max;
  Progress<S> progress(t, S(grid.end()) - t);
  while (auto stop = walk.next()) {
    while (due && !stop->is_event && stop->t < S(grid.end())) stop = walk.next();
    // The run stops just before the event, so that quantities that jump have their earlier value. 8 epsilon
    // exceed the rounding of times: no evaluation of the last step lies beyond the event.
    const S little = 8 * std::numeric_limits<S>::epsilon() * max(S(abs(S(grid.start()))), S(abs(stop->t)));
    const S target = stop->is_event ? stop->t - little : stop->t;
    while (t < target) {
      const S begin = t, given = grid.has_given_steps() ? S(target - t) : S(0);
      before = y;
      const auto attempt = [&](const S& at, const StateVector<S>& reached, const auto& part) {
        with_cause(system, begin, before, given, part, [&] { outputs.add_reached(at, reached); });
      };
      attempt(begin, before, [&] {
        checked_step(system, method, begin, before, t, y, grid.latest_end(t, target), grid.has_given_steps(),
                     projects, project, report);
      });
      const bool looks_back = due && due->t < t;
      bool goes_on = true;  // if it is false after an output within the step, the run ends at the step's end
      for (; goes_on && due && due->t < t; due = following.next()) {
        StateVector<S> between;
        attempt(begin, before, [&] {
          method.interpolate(due->t, between);
          if (projects) project(system, due->t, between, report);
        });
        goes_on = outputs.add(due->t, between) == Continue::yes;
      }
      if (looks_back) {  // the method's lambda() is that of the step's end again
        StateVector<S> at_end;
        method.interpolate(t, at_end);
      }
      attempt(t, y, [&] {
        if (system.accept_state(t, y)) method.restart();
        progress.step(t);
      });
      outputs.forget_event();
      if (at_step(t, y) == Continue::no) goes_on = false;
      const bool is_output = due && due->t == t && due->t < stop->t;
      if (is_output) due = following.next();
      if ((is_output || !goes_on) && outputs.add(t, y) == Continue::no) goes_on = false;
      if (!goes_on) return false;
    }
    bool goes_on = true;
    try {
      if (stop->is_event) {
        const S before_t = std::exchange(t, stop->t);
        outputs.note_event(before_t, y);
        system.pass_discontinuity(before_t, t, y);
        system.accept_state(t, y);  // the motion starts anew here, as a run continued from here does
        method.restart();
        goes_on = at_step(t, y) == Continue::yes;
      }
      if (due) due = following.next();  // beyond this stop
      if ((stop->is_output || !goes_on) && outputs.add(t, y) == Continue::no) goes_on = false;
    } catch (const Error&) {
      outputs.add_before_event();
      throw;
    }
    if (!goes_on && !walk.is_done()) return false;
  }
  return true;
}

template bool integrate<double>(AnySystem<double>&, AnyMethod<double>&, const TimeGrid&, bool,
                                ProjectionReport<double>&,
                                const std::function<Continue(const double&, const StateVector<double>&)>&,
                                const std::function<Continue(const double&, const StateVector<double>&)>&);
template bool integrate<Quad>(AnySystem<Quad>&, AnyMethod<Quad>&, const TimeGrid&, bool,
                              ProjectionReport<Quad>&,
                              const std::function<Continue(const Quad&, const StateVector<Quad>&)>&,
                              const std::function<Continue(const Quad&, const StateVector<Quad>&)>&);

}  // namespace trivium::integrators
