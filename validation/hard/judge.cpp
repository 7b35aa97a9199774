#include "validation/hard/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "base/number_text.hpp"
#include "formulations/formulation_list.hpp"
#include "integrators/contract/tolerances.hpp"
#include "integrators/methods.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/motion_warnings.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/announcement.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/methods.hpp"
#include "validation/hard/simbody_rows.hpp"

namespace trivium::hard {

namespace {

/// Says which branch the states are on. One that leaves its branch errs as much as can be, whenever it does.
void judge_branch(Row& row, const ExactMotion& exact, const std::vector<MechanismState<double>>& states) {
  const Branch& branch = exact.branch();
  if (branch.name.empty()) return;
  const auto left =
      std::find_if(states.begin(), states.end(), [&](const auto& state) { return !branch.holds(state); });
  if (left == states.end()) {
    row.why += fmt::format("; keeps its branch: {}", branch.name);
    return;
  }
  row.why += fmt::format("; on another branch at t = {:.3g}, not: {}",
                         exact.states()[left - states.begin()].t, branch.name);
  row.value = 1;
  if (!(row.threshold <= small_difference)) row.threshold = small_difference;
}

}  // namespace

Judge::Judge(std::string family, std::string name, bool is_twin, const Choice& choice)
    : family_(std::move(family)), name_(std::move(name)), is_twin_(is_twin), choice_(choice) {
  for (const std::string& formulation : formulation_names())
    if (choice.formulations.empty() || std::find(choice.formulations.begin(), choice.formulations.end(),
                                                 formulation) != choice.formulations.end())
      formulations_.push_back(formulation);
}

Row Judge::row(const std::string& formulation, const std::string& method, const std::string& quantity) const {
  Row row;
  row.family = family_;
  row.name = name_ + part_;
  row.formulation = formulation;
  row.method = method;
  row.quantity = quantity;
  row.is_twin = is_twin_;
  return row;
}

void Judge::keep_worst_part() {
  part_.clear();
  std::vector<Row> worst;
  for (Row& row : rows_) {
    row.why = fmt::format("worst:{}; {}", row.name.substr(name_.size()), row.why);
    row.name = name_;
    const auto same = std::find_if(worst.begin(), worst.end(), [&](const Row& other) {
      return std::tie(row.formulation, row.method, row.quantity) ==
             std::tie(other.formulation, other.method, other.quantity);
    });
    if (same == worst.end())
      worst.push_back(std::move(row));
    else if (is_worse(row, *same))
      *same = std::move(row);
  }
  rows_ = std::move(worst);
}

Row Judge::judged(Row row, double figure) const {
  if (row.is_met()) {
    row.verdict = Verdict::survives;
  } else if (std::isnan(row.value)) {
    row.verdict = Verdict::not_judged;
  } else if (figure >= std::min(row.value, 1.0) / 10) {
    // an estimate is relative to what was computed, which is as large as its error where no digit is right
    row.verdict = Verdict::announces;
    if (row.why.empty()) row.why = fmt::format("stated error {:.1e}", figure);
  } else {
    row.verdict = Verdict::fails;
    row.why = "no warning states such an error; " + row.why;
  }
  // a warning that always comes is none
  if (is_twin_ && figure > 0) {
    row.verdict = Verdict::fails;
    row.why = "the easy twin is warned of: " + row.why;
  }
  return row;
}

Row Judge::ended(Row row, const std::string& message, std::optional<double> when, const scenes::Scene& scene,
                 double start, double end, const std::string& reason) const {
  row.value = row.threshold = std::numeric_limits<double>::quiet_NaN();
  const std::string missing = missing_in_announcement(message, when, scene, start, end, reason);
  row.verdict = missing.empty() && !is_twin_ ? Verdict::announces : Verdict::fails;
  row.why = missing.empty() ? message : fmt::format("{}: {}", missing, message);
  return row;
}

Row Judge::refused(Row row, const std::string& message, const scenes::Scene& scene) const {
  const double t = number_after(message, "at t = ");
  return ended(std::move(row), message, std::isnan(t) ? std::nullopt : std::optional(t), scene);
}

Row Judge::exact_row(const std::string& law, double off, const ExactMotion& exact) const {
  Row row = this->row("r-omega", "exact motion", law);
  row.value = exact.trouble().empty() ? off : std::numeric_limits<double>::quiet_NaN();
  row.why = exact.trouble();
  row.tolerance = exact.tolerance();
  row.amplification = exact.amplification();
  row.threshold = std::min(factors::chosen_steps * row.tolerance * row.amplification, small_difference);
  return judged(std::move(row));
}

ExactMotion Judge::motion(const HardMotion& motion) {
  const ExactMotion exact(motion);
  const std::vector<std::string> methods =
      motion.methods.empty() ? methods_of(family_, choice_.is_quick) : motion.methods;
  const double steps = std::ceil(exact.output_step() / motion.step * (1 - 1e-9));
  for (const std::string& method : methods) {
    const integrators::MethodInfo& info = *integrators::find_method(method);
    for (const std::string& formulation : formulations_) {
      if (!goes_with(info, formulation)) continue;
      if (info.chooses_steps && motion.chooses_steps) run(motion, exact, formulation, method, {});
      if (info.takes_given_steps && motion.gives_steps)
        run(motion, exact, formulation, method, exact.output_step() / steps);
    }
  }
  if (motion.beside_simbody) add_simbody(motion, exact);
  return exact;
}

void Judge::add_simbody(const HardMotion& motion, const ExactMotion& exact, const std::string& remark) {
  if (!choice_.formulations.empty()) return;
  for (Row& row : simbody_rows(*this, motion, exact, motion.rtol)) {
    row.why = remark + row.why;
    add(std::move(row));
  }
}

void Judge::run(const HardMotion& motion, const ExactMotion& exact, const std::string& formulation,
                const std::string& method, std::optional<double> step) {
  SimulationOptions options;
  options.formulation = formulation;
  options.integrator = method;
  options.end = motion.end;
  options.step = step;
  options.output_step = exact.output_step();
  options.tolerances = motion.tolerances(motion.rtol);
  options.max_step = step ? std::nullopt : motion.max_step;
  options.charts = motion.charts;
  Row row = this->row(formulation, step ? fmt::format("{}, h = {:.3g}", method, *step) : method,
                      motion.monitor == Monitor::motion ? "motion [-]" : "positions [-]");
  LimitedSamples found(most_steps);
  SimulationReport report;
  try {
    report = simulate(make_model<double>(motion.scene, motion.start), options, found);
  } catch (const Error& error) {
    Row end = ended(row, error.what(), error.when(), motion.scene, motion.start, motion.end, motion.reason);
    if (error.kind() == ErrorKind::input) {  // its exit code is 2
      end.verdict = Verdict::fails;
      end.why = "an error of the input: " + end.why;
    }
    return add(std::move(end));
  }
  if (!report.complete) {
    row.value = std::numeric_limits<double>::quiet_NaN();
    row.why = fmt::format("given up after {} steps at t = {:g}", most_steps, report.reached);
    row.verdict = Verdict::not_judged;
    return add(std::move(row));
  }
  const double factor = step ? factors::given_steps : factors::chosen_steps;
  row.why = counted(report.counters.steps, "step", "steps");
  if (!exact.has_neighbours()) row.why += ", amplification unknown: neighbouring runs do not get through";
  if (!exact.trouble().empty()) {
    row.value = std::numeric_limits<double>::quiet_NaN();
    row.verdict = exact.is_given_up() ? Verdict::not_judged : Verdict::fails;
    row.why += ", though the exact motion ends: " + exact.trouble();
    return add(std::move(row));
  }
  const double of_steps = static_cast<double>(report.counters.steps) * motion.of_a_step();
  // roundings of the state are of either sign: they add up with the root of their number
  const double rounding = motion.rounding * std::sqrt(static_cast<double>(report.counters.steps));
  row.tolerance = rounding + (!step              ? of_steps
                              : motion.sums_hold ? stated_by(report, exact, *step)
                                                 : factors::unwarned);
  std::vector<MechanismState<double>> states;
  for (std::size_t k = 1; k < found.all.size(); ++k) states.push_back(found.all[k].state);
  judge_states(row, exact, states, factor);
  const double allowed = factors::phi * motion.of_a_step() + factors::state * motion.rounding +
                         factors::residual * integrators::rounding<double>() * exact.distance();
  if (const double off = report.phi / exact.length();
      (row.is_met() || std::isnan(row.value)) && off > allowed) {
    row.quantity = "Phi [-]";
    row.value = off;
    row.tolerance = motion.of_a_step();
    row.amplification = 1;
    row.threshold = allowed;
  }
  const double figure = quote_warnings(row, report);
  row = judged(std::move(row), figure);
  add(row);
  if (motion.also) motion.also(*this, {row, factor, report, figure});
}

double stated_by(const SimulationReport& report, const ExactMotion& exact, double step) {
  const auto& errors = report.local_errors;
  if (!errors || errors->steps == 0) return factors::unwarned;
  double rounding = unit_roundoff<double>() * static_cast<double>(report.counters.steps) *
                    static_cast<double>(exact.states().front().pose.size());
  if (report.is_implicit) rounding += exact.of_velocities(integrators::rounding<double>(), step);
  return std::min(exact.difference(*errors) + rounding, factors::unwarned);
}

double quote_warnings(Row& row, const SimulationReport& report) {
  double figure = 0;
  for (const MotionWarning& warning : motion_warnings(report)) {
    figure = std::max({figure, std::min(warning.relative_error, 1.0), std::numeric_limits<double>::min()});
    row.why += "; warned: " + warning.text;
  }
  return figure;
}

void promise(Row& row, double kappa, double tolerance, double largest) {
  row.tolerance = tolerance;
  row.amplification = kappa;
  row.threshold = std::min(factors::state * tolerance * kappa, largest);
}

void judge_states(Row& row, const ExactMotion& exact, const std::vector<MechanismState<double>>& states,
                  double factor) {
  double worst = -1;
  row.value = row.threshold = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < exact.states().size(); ++k) {
    const double amplification = exact.amplification(k), threshold = factor * row.tolerance * amplification;
    // from here on the tolerance promises nothing
    if (!(threshold <= small_difference)) {
      if (k > 0) row.why += fmt::format(", judged up to t = {:.3g}", exact.states()[k - 1].t);
      break;
    }
    const double value = std::min(exact.difference(states[k], k), 1.0);
    if (value / threshold <= worst) continue;
    worst = value / threshold;
    row.value = value;
    row.threshold = threshold;
    row.amplification = amplification;
  }
  judge_branch(row, exact, states);
}

}  // namespace trivium::hard
