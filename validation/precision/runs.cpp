/// Measures errors first, in one run per setting, then CPU times, in repeated runs that compute neither
/// lambda nor reactions.

#include "validation/precision/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/raise.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/rotations/so3.hpp"
#include "integrators/methods.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/simulate.hpp"
#include "validation/harness/interleaved_timing.hpp"
#include "validation/harness/timed_formulations.hpp"

namespace trivium::precision {

namespace {

/// Number of outputs of a run, at which errors are taken. Few outputs, because most methods end a step at
/// every output.
constexpr int outputs = 10;
/// A run is not repeated after this total CPU time [s]: longer runs repeat well enough, and would take long.
constexpr double enough = 1;

SimulationOptions options_of(const TimedMotion& motion, const RunSettings& settings) {
  SimulationOptions options;
  options.formulation = settings.formulation;
  options.integrator = settings.method;
  options.parameters = settings.parameters;
  options.end = motion.t_end;
  options.output_step = motion.t_end / outputs;
  // atol below rtol, so that rtol also governs coordinates smaller than 1
  if (settings.rtol) options.tolerances = {*settings.rtol, *settings.rtol / 100};
  if (settings.step) options.step = *settings.step * motion.t_end;
  return options;
}

void add_errors(const MechanismState<double>& found, const MechanismState<double>& exact,
                MotionErrors& errors) {
  for (std::size_t b = 0; b < exact.pose.size(); ++b) {
    raise(errors.position, (found.pose[b].r - exact.pose[b].r).norm());
    const Vector4<double> between =
        multiply_parameters<double>(conjugate_parameters<double>(exact.pose[b].p), found.pose[b].p);
    raise(errors.orientation, rotation_vector<double>(between).norm());
    raise(errors.velocity, (found.twist[b].r_dot - exact.twist[b].r_dot).norm());
    raise(errors.velocity, (found.twist[b].omega_bar - exact.twist[b].omega_bar).norm());
  }
}

void measure_ours(const TimedMotion& motion, const ReferenceMotion& reference, RunResult& result) {
  Samples samples;
  const SimulationReport report = simulate(motion.model(), options_of(motion, result.settings), samples);
  double reaction = 0;
  for (std::size_t k = 0; k < reference.samples.size(); ++k) {
    add_errors(samples.all[k].state, reference.samples[k].state, result.errors);
    for (std::size_t j = 0; j < samples.all[k].reactions.size(); ++j)
      raise(reaction, (samples.all[k].reactions[j].force - reference.samples[k].reactions[j].force).norm());
  }
  result.errors.reaction = reaction;
  result.errors.drift = report.phi;
  result.errors.energy = report.unaccounted_energy;
  result.steps = report.counters.steps;
  result.evaluations = report.counters.right_sides;
  result.factorisations = report.factorisations;
}

void measure_peer(const TimedMotion& motion, const ReferenceMotion& reference, RunResult& result) {
  const PeerMotion found = peer_motion(motion, result.settings);
  for (std::size_t k = 0; k < found.states.size(); ++k)
    add_errors(found.states[k], reference.samples[k + 1].state, result.errors);
  result.steps = found.steps;
  result.evaluations = found.evaluations;
}

double time_once(const TimedMotion& motion, const RunSettings& settings) {
  if (settings.formulation.empty()) return peer_motion(motion, settings).seconds;
  SimulationObserver nobody;
  SimulationOptions options = options_of(motion, settings);
  options.watches = false;
  return simulate(motion.model(), options, nobody).seconds;
}

/// The interval reaches from the second smallest to the second largest time; below 5 times from the smallest
/// to the largest (see confidence()).
Seconds summary(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const std::size_t n = seconds.size(), in = n >= 5 ? 1 : 0;
  return {seconds.front(), median_of(seconds), seconds[in], seconds[n - 1 - in]};
}

}  // namespace

std::string RunSettings::setting() const {
  if (rtol) return fmt::format("rtol {:.0e}", *rtol);
  return fmt::format("h = T/{:.0f}", 1 / *step);
}

std::vector<double> output_times(const TimedMotion& motion) {
  std::vector<double> times;
  for (int k = 1; k <= outputs; ++k)
    times.push_back(k == outputs ? motion.t_end : k * (motion.t_end / outputs));
  return times;
}

ReferenceMotion reference_of(const TimedMotion& motion) {
  Samples first, second;
  const auto model = make_model<Quad>(motion.scene);
  // two methods with tolerances below the rounding of double
  SimulationOptions options = options_of(motion, {"trivium", "r-omega", "rkf78", 1e-16, {}});
  simulate(model, options, first);
  options.integrator = "bulirsch-stoer";
  options.tolerances = {1e-17, 1e-19};
  simulate(model, options, second);
  MotionErrors apart;
  for (std::size_t k = 0; k < first.all.size(); ++k)
    add_errors(first.all[k].state, second.all[k].state, apart);
  const std::optional<double> trusted = apart_from_trusted(motion.scene.name, second.all);
  return {second.all, std::max(apart.position, trusted.value_or(0)), trusted.has_value()};
}

std::vector<double> tolerances(bool quick) {
  if (quick) return {1e-5, 1e-9};
  return {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
}

/// Methods of low order are measured with given steps: the tolerances above span nine decades, for
/// which a method of order p takes 10^(9/(p+1)) times as many steps: a thousand times with order 2.
bool is_measured_by_tolerances(const integrators::MethodInfo& method) {
  const bool has_low_order = method.takes_given_steps && method.standard_order <= 4;
  return method.chooses_steps && !has_low_order;
}

std::vector<RunSettings> all_settings(bool quick) {
  std::vector<RunSettings> all;
  // steps in the whole run
  const auto steps = quick ? std::vector<double>{200} : std::vector<double>{200, 800, 3200};
  for (const std::string& formulation : TimedFormulations::names()) {
    for (const integrators::MethodInfo& method : integrators::methods())
      if (is_measured_by_tolerances(method))
        for (const double rtol : tolerances(quick))
          all.push_back({"trivium", formulation, std::string(method.name), rtol, {}});
    if (!quick)
      for (const char* method : {"rkf78", "bulirsch-stoer", "abm", "cvode-adams"})
        for (const double rtol : finest_tolerances) all.push_back({"trivium", formulation, method, rtol, {}});
    for (const integrators::MethodInfo& method : integrators::methods()) {
      if (is_measured_by_tolerances(method) || !goes_with(method, formulation)) continue;
      integrators::MethodParameters parameters;
      if (method.takes_order) parameters.order = 4;
      for (const double n : steps)
        all.push_back({"trivium", formulation, std::string(method.name), {}, 1 / n, parameters});
    }
  }
  const std::vector<RunSettings> peers = peer_settings(quick);
  all.insert(all.end(), peers.begin(), peers.end());
  return all;
}

std::vector<RunResult> measure_runs(const TimedMotion& motion, const ReferenceMotion& reference,
                                    const std::vector<RunSettings>& all, int repetitions,
                                    const std::function<void()>& step) {
  std::vector<RunResult> runs;
  for (const RunSettings& settings : all) {
    RunResult& result = runs.emplace_back(RunResult{settings, {}, {}, {}});
    try {
      (settings.formulation.empty() ? measure_peer : measure_ours)(motion, reference, result);
    } catch (const std::runtime_error& error) {
      result.failure = error.what();
    }
    step();
  }
  std::vector<std::vector<double>> seconds(all.size());
  interleave(
      all.size(), repetitions,
      [&](std::size_t n) {
        const double spent = std::accumulate(seconds[n].begin(), seconds[n].end(), 0.0);
        if (runs[n].solved() && spent < enough) seconds[n].push_back(time_once(motion, all[n]));
      },
      step);
  for (std::size_t n = 0; n < all.size(); ++n)
    if (runs[n].solved() && repetitions > 0) runs[n].seconds = summary(seconds[n]);
  return runs;
}

double confidence(int repetitions) {
  // The interval misses the median if all repetitions, or from 5 on all but one, fall on one side of it.
  const double n = repetitions;
  return 1 - std::pow(0.5, n - 1) * (repetitions >= 5 ? n + 1 : 1);
}

}  // namespace trivium::precision
