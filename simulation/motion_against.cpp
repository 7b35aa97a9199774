/// Every formulation is run such that its outputs are the times of the other motion. If these times are
/// not evenly spaced, a run is made from each of them to the next, which begins where the one before ended.

#include "simulation/motion_against.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/raise.hpp"
#include "formulations/analysis/consistency.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "simulation/motion_csv.hpp"
#include "simulation/neighbouring_start.hpp"

namespace trivium {

namespace {

/// The lines of a motion's CSV file (motion_csv.hpp), one per time.
using Lines = std::vector<std::vector<double>>;

/// The kind of a column, such as "place", "v" or "lambda". All columns of one kind share one size.
std::string kind_of(const std::string& column) {
  const std::size_t dot = column.rfind('.');
  if (dot == std::string::npos) return column.substr(0, column.find('['));
  const std::string part = column.substr(dot + 1);
  return part.size() == 1 ? "place" : part.substr(0, 1);
}

/// The step between evenly spaced times [s]; none if they are not even within rounding.
std::optional<double> even_step(const std::vector<double>& t) {
  const double span = t.back() - t.front(), step = span / static_cast<double>(t.size() - 1);
  for (std::size_t k = 0; k < t.size(); ++k)
    // 1e-9: another code may write its times with ten digits
    if (!(std::abs(t[k] - (t.front() + static_cast<double>(k) * step)) <= 1e-9 * span)) return {};
  return step;
}

/// Runs a formulation and collects its output at given times.
class Walker {
 public:
  Walker(const ComparedFormulation& formulation, const SimulationOptions& options)
      : formulation_(formulation), options_(options) {
    options_.formulation = formulation.name;
  }

  Lines walk(Model<double> model, const std::vector<double>& t) {
    if (t.front() > model.state.t) go(model, t.front());
    Lines lines;
    const auto add = [&](const MotionSample& sample) { lines.push_back(motion_numbers(sample, false)); };
    if (const auto step = even_step(t)) {
      for (const MotionSample& sample : go(model, t.back(), step).all) add(sample);
    } else {
      for (std::size_t k = 1; k < t.size(); ++k) {
        const Samples part = go(model, t[k]);
        if (k == 1) add(part.all.front());
        add(part.all.back());
      }
    }
    return lines;
  }

  long steps = 0;
  SimulationReport last;

 private:
  /// Simulates from the model's state to `end`, moves the model there, and returns the outputs.
  Samples go(Model<double>& model, double end, std::optional<double> output_step = {}) {
    options_.end = end;
    options_.output_step = output_step;
    Samples record;
    last = formulation_.simulate(model, options_, record);
    steps += last.counters.steps;
    model = model_at(model, last.end.state, last.end.run.angles);
    model.state.t = end;
    return record;
  }

  const ComparedFormulation& formulation_;
  SimulationOptions options_;
};

/// The reason why a column has no bound; empty if it has one. Violations phi are no property of the motion,
/// and multipliers or reactions that are not unique are a matter of choice.
std::string reason_not_to_judge(const std::string& column, const Model<double>& model,
                                const std::vector<bool>& unique) {
  if (column.starts_with("phi")) return "not judged: constraint violation";
  const auto is_open = [&](int first, int count) {
    return std::find(unique.begin() + first, unique.begin() + first + count, false) !=
           unique.begin() + first + count;
  };
  if (column.starts_with("lambda[")) return is_open(std::stoi(column.substr(7)), 1) ? "not unique" : "";
  for (const Joint<double>& joint : model.mechanism.joints)
    if (std::ranges::any_of(std::array{"fx", "fy", "fz", "tx", "ty", "tz"},
                            [&](const char* part) { return column == joint.name + "." + part; }))
      return is_open(joint.first_row, joint.rows) ? "not unique" : "";
  return "";
}

/// Gives our Euler parameters the sign of theirs, because p and -p are the same orientation. Only bodies of
/// which the other file has all four are changed.
void turn_to(const OtherMotion& other, const std::map<std::string, std::size_t>& place, Lines& lines) {
  for (const OtherMotion::Column& first : other.columns) {
    if (!first.ours.ends_with(".e0")) continue;
    const std::string body = first.ours.substr(0, first.ours.size() - 1);
    std::vector<std::pair<const OtherMotion::Column*, std::size_t>> all;
    for (const OtherMotion::Column& column : other.columns)
      if (column.ours.size() == body.size() + 1 && column.ours.starts_with(body))
        all.emplace_back(&column, place.at(column.ours));
    if (all.size() != 4) continue;
    for (std::size_t n = 0; n < lines.size(); ++n) {
      double dot = 0;
      for (const auto& [column, at] : all) dot += column->value[n] * lines[n][at];
      if (dot < 0)
        for (const auto& [column, at] : all) lines[n][at] = -lines[n][at];
    }
  }
}

/// A motion from a neighbouring start, and the relative distance of that start.
struct Neighbour {
  double distance;
  Lines lines;
};

/// Per time and column: the largest change of a formulation by half the step.
Lines changes_by_half_the_step(const std::vector<ComparedFormulation>& formulations,
                               const std::vector<Lines>& all, const Model<double>& model,
                               const OtherMotion& other, const std::map<std::string, std::size_t>& place,
                               SimulationOptions options) {
  options.step = *options.step / 2;
  Lines changes(all.front().size(), std::vector<double>(all.front().front().size(), 0.));
  for (std::size_t f = 0; f < formulations.size(); ++f) {
    Lines half = Walker(formulations[f], options).walk(model, other.t);
    turn_to(other, place, half);
    for (std::size_t n = 0; n < half.size(); ++n)
      for (std::size_t k = 0; k < half[n].size(); ++k)
        raise(changes[n][k], std::abs(half[n][k] - all[f][n][k]));
  }
  return changes;
}

/// Whether two motions have diverged: a place differs by small_difference of the mechanism's length, or an
/// Euler parameter by small_difference.
bool has_parted(const std::vector<std::string>& names, const std::vector<double>& x,
                const std::vector<double>& y, double length) {
  for (std::size_t k = 1; k < names.size(); ++k) {
    const std::string kind = kind_of(names[k]);
    const double allowed = small_difference * (kind == "place" ? length : 1);
    if ((kind == "place" || kind == "e") && !(std::abs(x[k] - y[k]) <= allowed)) return true;
  }
  return false;
}

}  // namespace

bool MotionAgainst::is_judged() const { return !judged_until || *judged_until > judged_from; }

bool MotionAgainst::holds() const {
  return complete() && is_judged() &&
         std::all_of(columns.begin(), columns.end(), [](const ColumnAgainst& c) { return c.holds(); });
}

MotionAgainst compare_against(const std::vector<ComparedFormulation>& formulations,
                              const Model<double>& model, const OtherMotion& other,
                              const SimulationOptions& options) {
  if (other.t.front() < model.state.t)
    throw Error(ErrorKind::input,
                fmt::format("the other motion begins at t = {}, before the scene's state at t = {}",
                            other.t.front(), model.state.t));
  const std::vector<std::string> names = motion_columns(model.mechanism, false);
  std::map<std::string, std::size_t> place;
  for (std::size_t k = 0; k < names.size(); ++k) place.emplace(names[k], k);
  MotionAgainst out;
  std::vector<Lines> all;
  long steps = 1;
  for (const ComparedFormulation& formulation : formulations) {
    ComparedRun& run = out.runs.emplace_back();
    run.formulation = formulation.name;
    try {
      Walker walker(formulation, options);
      all.push_back(walker.walk(model, other.t));
      run.report = walker.last;
      run.report.counters.steps = walker.steps;
      steps = std::max(steps, walker.steps);
      turn_to(other, place, all.back());
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::input) throw;  // the request is wrong, not one formulation
      run.error = error.what();
    }
  }
  if (!out.complete()) return out;

  const Lines& ours = all.front();
  const double tolerance = options.tolerances.rtol + options.tolerances.atol;
  // motions from neighbouring starts measure how a difference is amplified
  std::vector<Neighbour> near;
  for (int seed = 1; seed <= neighbours; ++seed) {
    const NeighbouringStart start = neighbouring_start(model, tolerance, seed);
    if (!(start.distance > 0)) break;  // the constraints leave no neighbour
    near.push_back({start.distance,
                    Walker(formulations.front(), options).walk({model.mechanism, start.state}, other.t)});
    turn_to(other, place, near.back().lines);
    raise(out.neighbour_distance, start.distance);
  }
  const Lines changed =
      options.step ? changes_by_half_the_step(formulations, all, model, other, place, options) : Lines();

  std::map<std::string, double> size;
  for (std::size_t k = 0; k < names.size(); ++k)
    for (const auto& line : ours) raise(size[kind_of(names[k])], std::abs(line[k]));
  const double length = std::max(size["place"], extent_of(model.mechanism, model.state).length);
  for (std::size_t n = 0; n < ours.size() && !out.judged_until; ++n)
    for (const Neighbour& other_start : near)
      if (has_parted(names, ours[n], other_start.lines[n], length)) out.judged_until = other.t[n];

  const std::vector<bool> unique =
      is_beyond_dense(model.mechanism) ? structured_row_analysis(model).unique : analyse_rows(model).unique;
  const double span = other.t.back() - model.state.t;
  out.judged_from = other.t.front();
  for (const OtherMotion::Column& column : other.columns) {
    const std::size_t k = place.at(column.ours);
    ColumnAgainst& c = out.columns.emplace_back();
    c.theirs = column.theirs;
    c.ours = column.ours;
    c.size = size[kind_of(column.ours)];
    c.not_judged = reason_not_to_judge(column.ours, model, unique);
    double amplification = c.size, change = 0, worst = -1;
    for (std::size_t n = 0; n < other.t.size(); ++n) {
      if (out.judged_until && other.t[n] >= *out.judged_until) break;
      for (const Neighbour& start : near)
        raise(amplification, std::abs(start.lines[n][k] - ours[n][k]) / start.distance);
      if (!changed.empty()) raise(change, changed[n][k]);
      // The amplification is at least the size of the column: each code may err by the tolerance relative to
      // this size. 1e-12 of the size, about 1e4 u, is the rounding of both codes.
      const double so_far = std::max(1.0, static_cast<double>(steps) * (other.t[n] - model.state.t) / span);
      const double by_tolerance = so_far * tolerance * amplification;
      const double bound = (options.step ? 2 * change : by_tolerance) + by_tolerance + 1e-12 * c.size;
      double difference = 0;
      for (const Lines& lines : all) raise(difference, std::abs(lines[n][k] - column.value[n]));
      const double ratio = bound > 0 ? difference / bound : difference > 0 ? INFINITY : 0;
      if (!(ratio <= worst) && worst == worst) {  // a NaN is taken, and then kept
        worst = ratio;
        c.difference = difference;
        c.bound = bound;
        c.t = other.t[n];
      }
    }
  }
  if (std::all_of(out.columns.begin(), out.columns.end(),
                  [](const ColumnAgainst& c) { return !c.not_judged.empty(); }))
    throw Error(ErrorKind::input,
                "the other motion has no column with a bound; give positions, velocities, or multipliers and "
                "reactions that are unique");
  if (!out.is_judged())
    for (ColumnAgainst& c : out.columns) c.not_judged = "not judged";
  return out;
}

}  // namespace trivium
