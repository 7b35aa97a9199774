/// First every formulation is run. Then the kept samples are compared output by output; further runs give the
/// bound along the motion, and some outputs are solved again in all formulations.

#include "simulation/motion_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/raise.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "integrators/methods.hpp"
#include "simulation/neighbouring_start.hpp"

namespace trivium {

namespace {

using Motion = std::vector<MotionSample>;

/// Keeps the outputs of a run, and reports its progress.
class Recorder : public Samples {
 public:
  explicit Recorder(const std::function<void(double)>& tell = {}) : tell_(tell) {}
  bool step(double t) override {
    if (tell_) tell_(t);
    return true;
  }

 private:
  std::function<void(double)> tell_;
};

/// The norms of the rows and the unique multipliers. The structured analysis is tried first; it has no norms
/// if an inertia is singular, and the dense analysis is used then.
RowAnalysis norms_at(const Model<double>& model) {
  if (model.mechanism.nc() > 0) {
    RowAnalysis rows = structured_row_analysis(model);
    if (rows.E.size() > 0) return rows;
  }
  return analyse_rows(model);
}

class Comparer {
 public:
  Comparer(const std::vector<ComparedFormulation>& formulations, const Model<double>& model,
           const ComparisonOptions& options)
      : formulations_(formulations), model_(model), options_(options), run_(options.run) {
    if (!run_.output_step) run_.output_step = (run_.end - model.state.t) / options.outputs;
    // Progress in units of one run. Each formulation has its run, and its compared states count as another.
    // The bound needs either the neighbouring starts or, with given steps, one run of half the step for each
    // formulation, which counts as 2.
    const double runs = static_cast<double>(formulations.size());
    all_ = (run_.step ? 3 * runs : runs + neighbours) + runs;
  }

  MotionComparison compare() {
    for (const ComparedFormulation& formulation : formulations_) run(formulation);
    if (!out_.complete()) return std::move(out_);
    find_norms();
    for (std::size_t k = 0; k < norms_.size(); ++k) compare_output(k);
    if (run_.step)
      bound_by_halved_steps();
    else
      bound_by_neighbours();
    mark_singular_positions();
    compare_states();
    return std::move(out_);
  }

 private:
  Motion& motion(std::size_t f) { return out_.samples[f]; }

  Recorder recorder(double share) {
    const double start = model_.state.t, span = run_.end - start, from = done_;
    done_ += share;
    if (!options_.progress) return Recorder();
    return Recorder([this, start, span, from, share](double t) {
      options_.progress((from + share * (t - start) / span) / all_);
    });
  }

  void run(const ComparedFormulation& formulation) {
    ComparedRun& one = out_.runs.emplace_back();
    one.formulation = formulation.name;
    Recorder record = recorder(1);
    SimulationOptions options = run_;
    options.formulation = formulation.name;
    try {
      one.report = formulation.simulate(model_, options, record);
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::input) throw;  // the request is wrong, not one formulation
      one.error = error.what();
    }
    for (const MotionSample& sample : record.all)
      for (const std::string& chart : sample.charts)
        if (std::find(one.charts.begin(), one.charts.end(), chart) == one.charts.end())
          one.charts.push_back(chart);
    out_.samples.push_back(std::move(record.all));
  }

  void find_norms() {
    out_.has_unique_lambda = false;
    for (const MotionSample& sample : motion(0)) {
      norms_.push_back(norms_at(model_at(model_, sample.state, sample.angles)));
      for (const bool unique : norms_.back().unique)
        out_.has_unique_lambda = out_.has_unique_lambda || unique;
    }
  }

  void compare_output(std::size_t k) {
    ComparedInstant& now = out_.instants.emplace_back();
    now.t = motion(0)[k].state.t;
    for (std::size_t a = 0; a < formulations_.size(); ++a)
      for (std::size_t b = a + 1; b < formulations_.size(); ++b) {
        const MotionSample &x = motion(a)[k], &y = motion(b)[k];
        raise(now.lambda, lambda_distance(norms_[k], x.lambda, y.lambda));
        for (std::size_t n = 0; n < x.state.pose.size(); ++n) {
          raise(now.position, (x.state.pose[n].r - y.state.pose[n].r).norm());
          raise(now.rotation, turn_between(x.state.pose[n].p, y.state.pose[n].p));
        }
      }
  }

  /// The bound for chosen steps: every step may have an error of the tolerance, and the motion amplifies this
  /// error as it amplifies a difference of the start.
  void bound_by_neighbours() {
    const double tolerance = run_.tolerances.rtol + run_.tolerances.atol;
    std::vector<Neighbour> near;
    for (int seed = 1; seed <= neighbours; ++seed) {
      Neighbour one = neighbouring_motion(tolerance, seed);
      if (!(one.distance > 0)) break;  // the constraints leave no neighbour
      raise(out_.neighbour_distance, one.distance);
      near.push_back(std::move(one));
    }
    long steps = 0;
    for (const ComparedRun& one : out_.runs) steps = std::max(steps, one.report.counters.steps);
    double amplification = 1;
    const double span = run_.end - model_.state.t;
    for (std::size_t k = 0; k < out_.instants.size(); ++k) {
      ComparedInstant& now = out_.instants[k];
      bool is_near = true;
      for (const Neighbour& one : near) {
        const double apart = lambda_distance(norms_[k], motion(0)[k].lambda, one.motion[k].lambda);
        raise(amplification, apart / one.distance);
        is_near = is_near && apart <= small_difference;
      }
      now.amplification = amplification;
      const double steps_so_far = std::max(1.0, static_cast<double>(steps) * (now.t - model_.state.t) / span);
      now.lambda_bound = steps_so_far * tolerance * amplification;
      // beyond a small difference the effect of an error is no longer proportional to the error
      if (!(is_near && now.lambda_bound <= small_difference) && !out_.judged_until) out_.judged_until = now.t;
    }
  }

  /// A motion from a neighbouring start, and the relative distance of that start; 0 if there is none.
  struct Neighbour {
    Motion motion;
    double distance = 0;
  };
  /// The neighbour of the first formulation's motion. If lambda is far more sensitive than the state, the
  /// neighbour's lambda differs too much already at the start; a nearer neighbour is taken then.
  Neighbour neighbouring_motion(double tolerance, int seed) {
    for (double in_tolerances = distance_in_tolerances;; in_tolerances /= 100) {
      const NeighbouringStart start = neighbouring_start(model_, tolerance, seed, in_tolerances);
      if (!(start.distance > 0)) return {};
      Recorder record = recorder(in_tolerances == distance_in_tolerances ? 1 : 0);
      SimulationOptions options = run_;
      options.formulation = formulations_.front().name;
      formulations_.front().simulate({model_.mechanism, start.state}, options, record);
      const bool is_near =
          lambda_distance(norms_[0], motion(0)[0].lambda, record.all[0].lambda) <= small_difference;
      // 0.02 ends the search after three distances: 100, 1 and 0.01 tolerances
      if (is_near || in_tolerances < 0.02) return {std::move(record.all), start.distance};
    }
  }

  /// The bound for given steps. To leading order, halving the step removes at least half of the error, also
  /// for a method of order 1. Twice the change therefore bounds the error.
  void bound_by_halved_steps() {
    std::vector<std::vector<double>> error(formulations_.size());
    for (std::size_t f = 0; f < formulations_.size(); ++f) {
      Recorder record = recorder(2);
      SimulationOptions options = run_;
      options.formulation = formulations_[f].name;
      options.step = *run_.step / 2;
      formulations_[f].simulate(model_, options, record);
      double largest = 0;
      for (std::size_t k = 0; k < out_.instants.size(); ++k) {
        raise(largest, lambda_distance(norms_[k], motion(f)[k].lambda, record.all[k].lambda));
        error[f].push_back(2 * largest);
      }
    }
    for (std::size_t k = 0; k < out_.instants.size(); ++k) {
      double first = 0, second = 0;  // the two largest errors
      for (const std::vector<double>& of : error) {
        const double x = std::max(of[k], rounding_of_lambda);
        second = std::max(second, std::min(first, x));
        first = std::max(first, x);
      }
      out_.instants[k].lambda_bound = first + second;
      if (!(first <= small_difference) && !out_.judged_until) out_.judged_until = out_.instants[k].t;
    }
  }

  /// Marks the outputs within two average steps of a singular position that a run passed. The time of a
  /// passage is the end of the step that found it, and this step may be longer than the average.
  void mark_singular_positions() {
    const double span = run_.end - model_.state.t;
    for (const ComparedRun& one : out_.runs)
      for (const SingularPassage& passage : one.report.passages)
        for (ComparedInstant& now : out_.instants)
          if (std::abs(now.t - passage.t) <= 2 * span / static_cast<double>(one.report.counters.steps))
            now.is_singular = true;
  }

  /// Solves every formulation at the states of all runs.
  void compare_states() {
    if (is_beyond_dense(model_.mechanism)) return;
    const std::size_t outputs = out_.instants.size(),
                      states = std::min(outputs, static_cast<std::size_t>(affordable_states()));
    for (std::size_t n = 0; n < states; ++n) {
      const std::size_t k = states == 1 ? outputs - 1 : n * (outputs - 1) / (states - 1);
      ComparedInstant::OneState worst;
      for (std::size_t f = 0; f < formulations_.size(); ++f) {
        const MotionSample& sample = motion(f)[k];
        compare_state(model_at(model_, sample.state, sample.angles), worst);
        done_ += 1.0 / static_cast<double>(states);
        if (options_.progress) options_.progress(std::min(1.0, done_ / all_));
      }
      out_.instants[k].one_state = worst;
    }
  }
  void compare_state(const Model<double>& model, ComparedInstant::OneState& worst) const {
    const RowAnalysis rows = analyse_rows(model);
    SideBySide<double> side{rows, {}};
    for (const ComparedFormulation& formulation : formulations_)
      side.formulations.push_back(formulation.solve(model, rows, run_.charts));
    const Discrepancy apart = side.discrepancy();
    const double bound = side.lambda_bound();
    double acceleration = 0;
    for (std::size_t a = 0; a < side.formulations.size(); ++a)
      for (std::size_t b = a + 1; b < side.formulations.size(); ++b)
        raise(acceleration,
              acceleration_distance(rows, side.formulations[a].solution, side.formulations[b].solution).all);
    const ComparedInstant::OneState here{apart.lambda, bound, acceleration, model.mechanism.nc() > 0,
                                         rows.kappa};
    // written so that a NaN is taken, and then kept
    const double ratio = here.ratio(), before = worst.ratio();
    if (worst.bound == 0 || (!(ratio <= before) && before == before)) worst = here;
  }

  /// The dense solver's cost grows as the cube of the unknowns. Beyond 500 unknowns the number of compared
  /// states is therefore multiplied by (500 / unknowns)^3, so that their total cost does not grow, but at
  /// least one is compared. 500 is chosen by experiment.
  int affordable_states() const {
    const double unknowns = 6.0 * model_.mechanism.nb() + model_.mechanism.nc();
    return std::max(1, static_cast<int>(std::min(1.0, std::pow(500 / unknowns, 3)) * options_.states));
  }

  /// Least relative error of lambda in double: the bound for given steps assumes at least this much. 1e-12 is
  /// about 1e4 u, the rounding at a kappa of 1e4. Runs with two step sizes may agree better by chance.
  static constexpr double rounding_of_lambda = 1e-12;

  const std::vector<ComparedFormulation>& formulations_;
  const Model<double>& model_;
  const ComparisonOptions& options_;
  SimulationOptions run_;
  std::vector<RowAnalysis> norms_;  ///< per output, at the state of the first formulation
  MotionComparison out_;
  double done_ = 0, all_ = 1;  ///< progress, in units of one run
};

}  // namespace

bool are_complete(const std::vector<ComparedRun>& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const ComparedRun& run) { return run.error.empty(); });
}

Model<double> model_at(const Model<double>& model, const MechanismState<double>& state,
                       const std::vector<double>& angles) {
  Model<double> moved{model.mechanism, state};
  std::size_t next = 0;
  moved.mechanism.effects.for_each_angle([&](JointAngle<double>& angle) { angle.tracked = angles[next++]; });
  return moved;
}

bool MotionComparison::is_judged(const ComparedInstant& now) const {
  return !now.is_singular && !(judged_until && now.t >= *judged_until);
}

bool MotionComparison::holds_along() const {
  return complete() && std::all_of(instants.begin(), instants.end(), [&](const ComparedInstant& now) {
           return !is_judged(now) || now.lambda <= now.lambda_bound;
         });
}

bool MotionComparison::holds_at_states() const {
  return complete() && std::all_of(instants.begin(), instants.end(), [](const ComparedInstant& now) {
           return !now.one_state || now.is_singular || now.one_state->holds();
         });
}

std::vector<ComparedFormulation> compared_formulations(const std::vector<std::string>& names,
                                                       const integrators::MethodInfo& method) {
  std::vector<ComparedFormulation> all;
  for (const std::string& name : formulation_names()) {
    if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
    if (!goes_with(method, name)) continue;
    all.push_back({name,
                   [](const Model<double>& model, const SimulationOptions& options,
                      SimulationObserver& observer) { return simulate(model, options, observer); },
                   [name](const Model<double>& model, const RowAnalysis& rows, const ChartOptions& charts) {
                     SideBySide<double> one = side_by_side(model, rows, {{name}, charts});
                     one.require_solved();
                     return std::move(one.formulations.front());
                   }});
  }
  return all;
}

MotionComparison compare_motion(const std::vector<ComparedFormulation>& formulations,
                                const Model<double>& model, const ComparisonOptions& options) {
  return Comparer(formulations, model, options).compare();
}

}  // namespace trivium
