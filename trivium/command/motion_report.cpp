/// Prints the summary of a run of `trivium simulate`. Lines that do not apply to the method are left out of
/// the text.

#include "trivium/command/motion_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "base/table.hpp"
#include "simulation/motion_warnings.hpp"

namespace trivium {

JsonWriter MotionReport::begin_json() const {
  const SimulationOptions& o = options;
  JsonWriter json;
  json.begin_object()
      .text("scene", mechanism.name)
      .text("formulation", o.formulation)
      .text("integrator", o.integrator)
      .number("t_start", t_start)
      .number("t_end", o.end);
  return json;
}

std::string MotionReport::json(const SimulationReport& r, const std::vector<ErrorByHalving>& verified) const {
  const SimulationOptions& o = options;
  JsonWriter json = begin_json();
  json.number("reached", r.reached).flag("complete", r.complete);
  if (o.step)
    json.number("step", *o.step);
  else
    json.number("rtol", o.tolerances.rtol).number("atol", o.tolerances.atol);
  const integrators::MethodParameters& p = o.parameters;
  if (p.order) json.number("order", *p.order);
  if (p.rho) json.number("rho", *p.rho);
  if (p.alpha) json.number("alpha", *p.alpha);
  if (r.is_implicit) json.flag("full_newton", p.full_newton.value_or(false));
  json.flag("projection", r.is_projected);
  if (o.baumgarte)
    json.begin_object("baumgarte")
        .number("alpha", o.baumgarte->alpha)
        .number("beta", o.baumgarte->beta)
        .end_object();
  json.number("steps", r.counters.steps)
      .number("rejected_steps", r.counters.rejected_steps)
      .number("right_sides", r.counters.right_sides)
      .number("newton_iterations", r.counters.iterations)
      .number("jacobians", r.jacobians)
      .number("factorisations", r.factorisations)
      .number("projection_changes", r.projection.changes)
      .number("restarts", r.counters.restarts)
      .number("reframings", r.reframings);
  json.begin_object("drift")
      .number("phi", r.phi)
      .number("phi_dot", r.phi_dot)
      .number("phi_before_projection", r.projection.position)
      .number("phi_dot_before_projection", r.projection.velocity)
      .number("normalisation", r.normalisation);
  if (r.has_raw_lambda) json.number("raw_lambda", r.lambda_gap);
  json.end_object();
  if (r.local_errors && r.local_errors->steps > 0)
    json.begin_object("local_errors")
        .number("position", r.local_errors->position)
        .number("velocity", r.local_errors->velocity)
        .number("steps", r.local_errors->steps)
        .end_object();
  json.begin_object("energy").number("start", r.energy_start).number("end", r.energy_end);
  if (r.does_work) json.number("work", r.work);
  json.number("unaccounted", r.unaccounted_energy).end_object();
  json.begin_array("singular_positions");
  for (const SingularPassage& passage : r.passages)
    json.begin_object().number("t", passage.t).number("rows", passage.rows).end_object();
  json.end_array();
  json.begin_array("impulses");
  for (const Impulse<double>& impulse : r.impulses)
    json.begin_object().number("t", impulse.t).numbers("lambda", impulse.lambda).end_object();
  json.end_array();
  if (!verified.empty()) {
    json.begin_array("verification");
    for (const ErrorByHalving& e : verified) {
      json.begin_object()
          .text("quantity", e.quantity)
          .text("unit", e.unit)
          .number("error", e.error)
          .number("t", e.t);
      if (e.order) json.number("observed_order", *e.order);
      json.number("order", e.expected_order).flag("reliable", e.is_reliable()).end_object();
    }
    json.end_array();
  }
  json.texts("rows", mechanism.row_names).texts("warnings", warnings_of(r)).end_object();
  return json.str();
}

std::string MotionReport::failure_json(const std::optional<double>& last, const char* error) const {
  JsonWriter json = begin_json();
  json.flag("complete", false);
  if (last) json.number("last_output", *last);
  return json.text("error", error).end_object().str();
}

std::string MotionReport::text(const SimulationReport& r, const std::vector<ErrorByHalving>& verified) const {
  const SimulationOptions& o = options;
  const std::string steps = o.step ? fmt::format("steps of {} s", *o.step)
                                   : fmt::format("rtol {}, atol {}", o.tolerances.rtol, o.tolerances.atol);
  std::string out = fmt::format("{}: t = {} to {}, {}\n\n", mechanism.name, t_start, r.reached, steps);
  Table table({"", fmt::format("{}, {}", o.formulation, o.integrator)});
  const auto add = [&](const std::string& name, const std::string& value) { table.add({name, value}); };
  add("steps", fmt::format("{}", r.counters.steps));
  add("rejected steps", fmt::format("{}", r.counters.rejected_steps));
  add("evaluations of the right side", fmt::format("{}", r.counters.right_sides));
  if (r.counters.iterations > 0) add("Newton iterations", fmt::format("{}", r.counters.iterations));
  if (r.jacobians > 0) add("Jacobians (Newton matrices)", fmt::format("{}", r.jacobians));
  add("factorisations", fmt::format("{}", r.factorisations));
  if (r.is_projected) add("projection corrections", fmt::format("{}", r.projection.changes));
  add("restarts", fmt::format("{}", r.counters.restarts));
  if (r.reframings > 0) add("re-framings (chart changes)", fmt::format("{}", r.reframings));
  add("position violation, largest [m, rad]", fmt::format("{:.1e}", r.phi));
  add("velocity violation, largest [m/s, rad/s]", fmt::format("{:.1e}", r.phi_dot));
  if (r.is_projected) {
    add("position violation before projection [m, rad]", fmt::format("{:.1e}", r.projection.position));
    add("velocity violation before projection [m/s, rad/s]", fmt::format("{:.1e}", r.projection.velocity));
  }
  if (r.has_raw_lambda) add("largest |raw lambda - lambda of (q, v)|", fmt::format("{:.1e}", r.lambda_gap));
  if (r.normalisation > 0) add("violation of p . p = 1, largest", fmt::format("{:.1e}", r.normalisation));
  if (r.local_errors && r.local_errors->steps > 0) {
    add("sum of local errors, positions [m]", fmt::format("{:.1e}", r.local_errors->position));
    add("sum of local errors, velocities [m/s]", fmt::format("{:.1e}", r.local_errors->velocity));
  }
  add("energy at the start [J]", fmt::format("{:.12g}", r.energy_start));
  add("energy at the end [J]", fmt::format("{:.12g}", r.energy_end));
  if (r.does_work) add("work of loads and drivers [J]", fmt::format("{:.12g}", r.work));
  add(r.does_work ? "largest energy error [J]" : "largest change of energy [J]",
      fmt::format("{:.1e}", r.unaccounted_energy));
  out += table.text();
  for (const Impulse<double>& impulse : r.impulses) {
    out += fmt::format(
        "\nvelocity jump of a driver at t = {}: impulse of every row [N s or N m s, divided by the scale of "
        "the row]\n",
        impulse.t);
    Table rows({"row", "impulse"});
    for (std::size_t k = 0; k < mechanism.row_names.size(); ++k)
      rows.add({mechanism.row_names[k], fmt::format("{:.9g}", impulse.lambda[static_cast<Eigen::Index>(k)])});
    out += rows.text();
  }
  if (!verified.empty()) {
    Table errors(
        {"error by halving the step", "unit", "error", "at t [s]", "observed order", "order of the method"});
    for (const ErrorByHalving& e : verified) {
      std::string order("rounding");
      if (e.order) order = fmt::format("{:.2f}{}", *e.order, e.is_reliable() ? "" : ", not reliable");
      errors.add({e.quantity, e.unit, fmt::format("{:.1e}", e.error), fmt::format("{:.6g}", e.t), order,
                  std::to_string(e.expected_order)});
    }
    out += fmt::format("\n{}", errors.text());
  }
  return out;
}

}  // namespace trivium
