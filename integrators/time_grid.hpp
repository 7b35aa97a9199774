#pragma once
/// The time grid of a run: the times of its outputs, given steps and events. Output k and given step k are at
/// start + k h, one product and one sum, so that rounding errors do not add up over the steps. A run ends a
/// step on every time of the grid, except on outputs within a step of a method that interpolates
/// (integrate.hpp).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "integrators/contract/errors.hpp"

namespace trivium::integrators {

/// Relative difference [-] up to which two step sizes count as equal. The rounding of decimal numbers and of
/// differences of times is far smaller, and no user means two step sizes by numbers this close.
inline constexpr double step_rounding = 1e-9;

/// Whether two step sizes between times of a grid are equal; if t is given, but for the rounding of times
/// near t.
template <class S>
bool is_same_length(const S& h, const S& last, const S& t = S(0)) {
  using std::abs;
  return abs(h - last) <= S(step_rounding) * abs(last) + 4 * std::numeric_limits<S>::epsilon() * abs(t);
}

/// A time on which a run lands exactly.
template <class S>
struct Stop {
  S t;
  bool is_output = false;
  bool is_event = false;  ///< the motion is not smooth there: multistep methods restart
};

/// Times from start to end (start < end) [s], with outputs every `output_step` and at the end, given steps of
/// size `step` if present, and events.
class TimeGrid {
 public:
  /// Throws a UsageError if the end is not after the start, if a step is not positive or too short, or if
  /// given steps do not divide the run and the output step.
  TimeGrid(double start, double end, std::optional<double> output_step = {}, std::optional<double> step = {},
           std::vector<double> events = {})
      : start_(start), end_(end), output_step_(output_step.value_or(end - start)), step_(step) {
    if (!(end > start)) throw UsageError(fmt::format("the end {} is not after the start {}", end, start));
    if (!(output_step_ > 0))
      throw UsageError(fmt::format("the output step {} is not positive", output_step_));
    outputs_ = number_of(output_step_);
    if (step_) {
      if (!(*step_ > 0)) throw UsageError(fmt::format("the step {} is not positive", *step_));
      require_whole(end - start, *step_, "run");
      if (output_step) require_whole(output_step_, *step_, "output step");
    }
    for (const double t : events)
      if (t > start && t <= end) events_.push_back(t);
    std::sort(events_.begin(), events_.end());
    events_.erase(std::unique(events_.begin(), events_.end()), events_.end());
  }

  double start() const { return start_; }
  double end() const { return end_; }

  /// The time at which the run begins: the start, or a later time if the run continues an earlier one.
  double begin() const { return begin_; }
  bool has_given_steps() const { return step_.has_value(); }
  /// Whether the run continues an earlier one, so that it begins after the start of the grid.
  bool goes_on() const { return begin_ != start_; }
  /// The same grid for a run that continues at time t. Throws a UsageError if t is not in [start, end).
  TimeGrid from(double t) const {
    if (!(t >= start_)) throw UsageError(fmt::format("the state at {} is before the start {}", t, start_));
    if (!(t < end_)) throw UsageError(fmt::format("the end {} is not after the state at {}", end_, t));
    TimeGrid grid = *this;
    grid.begin_ = t;
    return grid;
  }

  /// The same grid for a run whose chosen steps are at most this long [s]. Throws a UsageError if steps are
  /// given, or if the length is not positive.
  TimeGrid limited_to(double longest_step) const {
    if (step_) throw UsageError("a longest step limits chosen steps; leave out the given step or the limit");
    if (!(longest_step > 0))
      throw UsageError(fmt::format("the longest step {} is not positive", longest_step));
    TimeGrid grid = *this;
    grid.longest_step_ = longest_step;
    return grid;
  }
  /// `stop`, or an earlier time if a chosen step from t to `stop` would be too long.
  template <class S>
  S latest_end(const S& t, const S& stop) const {
    return longest_step_ && t + S(*longest_step_) < stop ? S(t + S(*longest_step_)) : stop;
  }

  /// Iterates over the stops: outputs, events, ends of given steps, and the end of the run.
  template <class S>
  class Walk {
   public:
    explicit Walk(const TimeGrid& grid) : grid_(grid) {
      if (!grid.goes_on()) return;
      // The indices are estimated from below, then increased until their times are after the begin.
      const auto before = [&](double step) {
        return std::max(1L, static_cast<long>((grid.begin_ - grid.start_) / step) - 1);
      };
      output_ = before(grid.output_step_);
      if (grid.step_) step_ = before(*grid.step_);
      while (Walk(*this).next_of_all().t <= S(grid.begin_)) next_of_all();
    }

    bool is_done() const { return done_; }
    /// The next stop; none after the end of the run.
    std::optional<Stop<S>> next() {
      if (done_) return {};
      return next_of_all();
    }

   private:
    Stop<S> next_of_all() {
      Stop<S> stop{S(grid_.end_), true, false};
      const S output = grid_.at<S>(output_, grid_.output_step_), step = next_step();
      const bool more_outputs = output_ <= grid_.outputs_ && !is_end(output);
      if (more_outputs) stop.t = output;
      if (grid_.step_ && step < stop.t && !are_same(step, stop.t)) stop = {step, false, false};
      if (event_ < grid_.events_.size()) {
        const S event(grid_.events_[event_]);
        if (are_same(event, stop.t)) {
          stop.is_event = true;
        } else if (event < stop.t) {
          stop = {event, false, true};
        }
        if (stop.is_event) ++event_;
      }
      if (more_outputs && are_same(output, stop.t)) ++output_;
      if (grid_.step_ && are_same(step, stop.t)) {
        // The two times may differ by rounding. In double the stop takes the time of the given step, so that
        // the lengths of steps do not depend on outputs and the end. In quad the step size is a rounded
        // double whose multiple misses the output in the 17th digit; there the stop keeps the time of the
        // output.
        if constexpr (std::is_same_v<S, double>) stop.t = step;
        ++step_;
      }
      done_ = is_end(stop.t);
      return stop;
    }
    S next_step() const { return grid_.step_ ? grid_.at<S>(step_, *grid_.step_) : S(grid_.end_); }
    bool is_end(const S& t) const { return !(t < S(grid_.end_)) || are_same(t, S(grid_.end_)); }
    /// Equal up to rounding in double, because the numbers of the grid are doubles: 8 epsilon for the
    /// product, the sum and the decimal numbers of each time.
    bool are_same(const S& a, const S& b) const {
      using std::abs;
      const double scale = std::max(std::abs(grid_.start_), std::abs(grid_.end_));
      return abs(a - b) <= S(8 * std::numeric_limits<double>::epsilon() * scale);
    }

    const TimeGrid& grid_;
    long output_ = 1, step_ = 1;
    std::size_t event_ = 0;
    bool done_ = false;
  };

 private:
  template <class S>
  S at(long k, double step) const {
    return S(start_) + S(static_cast<double>(k)) * S(step);
  }
  /// The number of steps that fit. 1e-12 keeps a last step that rounding has made too long; with at most 1e9
  /// outputs it is less than a thousandth of a step.
  long number_of(double step) const {
    const double ratio = (end_ - start_) / step;
    if (!(ratio < 1e9)) throw UsageError(fmt::format("the output step {} makes more than 1e9 outputs", step));
    return static_cast<long>(std::floor(ratio * (1 + 1e-12)));
  }
  /// Up to 1e15 steps can be counted in a double.
  static void require_whole(double length, double step, const char* what) {
    const double ratio = length / step, nearest = std::round(ratio);
    if (!(ratio < 1e15))
      throw UsageError(fmt::format("the step {} divides the {} of length {} into more than 1e15 steps", step,
                                   what, length));
    if (nearest < 1 || std::abs(ratio - nearest) > step_rounding * ratio)
      throw UsageError(
          fmt::format("the step {} does not divide the {} of length {} into equal parts; the nearest step "
                      "that does is {:.17g}",
                      step, what, length, length / std::max(1.0, nearest)));
  }

  double start_, end_, output_step_, begin_ = start_;
  std::optional<double> step_, longest_step_;
  long outputs_ = 0;
  std::vector<double> events_;
};

}  // namespace trivium::integrators
