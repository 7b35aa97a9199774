/// Prints a verdict and the largest difference for every column; decides no bound itself.

#include "trivium/command/against_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/csv.hpp"
#include "base/json_writer.hpp"
#include "base/number_text.hpp"
#include "base/table.hpp"

namespace trivium {

namespace {

std::string verdict_of(const ColumnAgainst& column) {
  return !column.not_judged.empty() ? column.not_judged : column.holds() ? "holds" : "EXCEEDS";
}

}  // namespace

std::string AgainstReport::text() const {
  std::vector<std::string> formulations;
  for (const ComparedRun& run : comparison.runs) formulations.push_back(run.formulation);
  std::string out = fmt::format("{} compared with {}: {} from t = {} to {}; {} by {}\n", scene, file,
                                counted(other.t.size(), "time", "times"), other.t.front(), other.t.back(),
                                fmt::join(formulations, ", "), options.integrator);
  if (comparison.columns.empty()) return out;
  Table table({"column", "name in the file", "difference", "bound", "at t [s]", "magnitude", "verdict"});
  for (const ColumnAgainst& c : comparison.columns)
    table.add({c.ours, c.theirs == c.ours ? "" : c.theirs, fmt::format("{:.1e}", c.difference),
               c.not_judged.empty() ? fmt::format("{:.1e}", c.bound) : "-", fmt::format("{:.6g}", c.t),
               fmt::format("{:.1e}", c.size), verdict_of(c)});
  out += fmt::format("\n{}\n", table.text());
  if (options.step)
    out +=
        "bound: twice the change by halving the step + number of steps * default tolerance * amplification "
        "(errors of the other code)\n";
  else if (comparison.neighbour_distance > 0)
    out += fmt::format(
        "bound: 2 * number of steps * tolerance * amplification, measured by runs from neighbouring "
        "starts at relative distance {:.1e}\n",
        comparison.neighbour_distance);
  else
    out +=
        "bound: 2 * number of steps * tolerance * magnitude; the constraints admit no neighbouring start\n";
  if (comparison.judged_until)
    out += fmt::format("from t = {:.6g} on, neighbouring motions have diverged: nothing is compared\n",
                       *comparison.judged_until);
  const auto exceeding = std::count_if(comparison.columns.begin(), comparison.columns.end(),
                                       [](const ColumnAgainst& c) { return !c.holds(); });
  if (!comparison.is_judged())
    out += "no column is judged\n";
  else if (exceeding == 0)
    out += "the motions agree\n";
  else
    out += fmt::format("{} of {} EXCEED their bounds\n", exceeding,
                       counted(comparison.columns.size(), "column", "columns"));
  return out;
}

std::string AgainstReport::json() const {
  JsonWriter json;
  json.begin_object()
      .text("scene", scene)
      .text("against", file)
      .text("integrator", options.integrator)
      .number("times", other.t.size())
      .number("t_start", other.t.front())
      .number("t_end", other.t.back())
      .texts("unknown_columns", other.unknown)
      .number("neighbour_distance", comparison.neighbour_distance);
  if (comparison.judged_until) json.number("judged_until", *comparison.judged_until);
  json.begin_array("runs");
  for (const ComparedRun& run : comparison.runs) {
    json.begin_object().text("formulation", run.formulation).number("steps", run.report.counters.steps);
    if (!run.error.empty()) json.text("error", run.error);
    json.end_object();
  }
  json.end_array().begin_array("columns");
  for (const ColumnAgainst& c : comparison.columns) {
    json.begin_object()
        .text("column", c.ours)
        .text("theirs", c.theirs)
        .number("difference", c.difference)
        .number("t", c.t)
        .number("size", c.size);
    if (c.not_judged.empty())
      json.number("bound", c.bound).flag("holds", c.holds());
    else
      json.text("not_judged", c.not_judged);
    json.end_object();
  }
  return json.end_array().flag("holds", comparison.holds()).end_object().str();
}

std::string AgainstReport::csv() const {
  std::string out = csv_line({"column", "theirs", "difference", "bound", "t", "size", "verdict"});
  for (const ColumnAgainst& c : comparison.columns)
    out += csv_line({c.ours, c.theirs, number_text(c.difference),
                     c.not_judged.empty() ? number_text(c.bound) : "", number_text(c.t), number_text(c.size),
                     verdict_of(c)});
  return out;
}

}  // namespace trivium
