/// Prints the analysis of a scene's state. A rank or condition number that the structured solver does not
/// compute is left out of the JSON and reported as "not determined" in the text.

#include "trivium/command/check_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/json_writer.hpp"
#include "base/raise.hpp"
#include "base/table.hpp"
#include "scenes/format/scene_keys.hpp"

namespace trivium {

namespace {

std::string joint_summary(const scenes::Scene& scene) {
  std::string out;
  for (const scenes::ConstraintShape& known : scenes::constraint_shapes()) {
    const auto count = std::count_if(scene.constraints.begin(), scene.constraints.end(),
                                     [&](const scenes::Constraint& c) { return c.type == known.type; });
    if (count > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, known.name());
  }
  return out.empty() ? "none" : out;
}

}  // namespace

std::vector<std::string> CheckReport::row_names(bool (*chosen)(const RowCheck&)) const {
  std::vector<std::string> out;
  for (std::size_t k = 0; k < check.rows.size(); ++k)
    if (chosen(check.rows[k])) out.push_back(check.names.rows[k]);
  return out;
}

std::vector<std::string> CheckReport::dependent() const {
  return row_names([](const RowCheck& row) { return row.is_dependent; });
}

std::vector<std::string> CheckReport::not_unique() const {
  return row_names([](const RowCheck& row) { return !row.is_unique; });
}

std::string CheckReport::json() const {
  JsonWriter json;
  json.begin_object()
      .text("scene", scene.name)
      .number("t", check.t)
      .number("nb", check.names.bodies.size())
      .number("nc", check.rows.size())
      .text("solver", check.solver);
  if (check.rank) json.number("dof", *check.degrees_of_freedom).number("rank", *check.rank);
  if (check.condition) json.number("condition", *check.condition);
  json.numbers("mu", check.mu)
      .texts("dependent", dependent())
      .texts("not_unique", not_unique())
      .texts("contradictory", check.contradictory)
      .texts("warnings", check.warnings)
      .texts("unphysical_inertia", check.unphysical_inertia)
      .flag("consistent", check.is_consistent)
      .texts("wrong_branches", check.wrong_branches)
      .number("kinetic_energy", check.kinetic_energy)
      .number("potential_energy", check.potential_energy)
      .number("effect_power", check.effect_power);
  json.begin_array("rows");
  for (std::size_t k = 0; k < check.rows.size(); ++k)
    json.begin_object()
        .text("name", check.names.rows[k])
        .number("position_residual", check.rows[k].position_residual)
        .number("velocity_residual", check.rows[k].velocity_residual)
        .flag("unique", check.rows[k].is_unique)
        .end_object();
  json.end_array().begin_array("augmented_matrix");
  for (const Sparsity& s : sparsity)
    json.begin_object()
        .text("formulation", s.name)
        .number("size", s.size)
        .number("nonzeros", s.nonzeros)
        .number("percent", s.percent())
        .end_object();
  return json.end_array().end_object().str();
}

std::string CheckReport::text() const {
  std::string out = fmt::format("{}: {}\n", scene.name, scene.description);
  if (!scene.reference.empty()) out += fmt::format("reference: {}\n", scene.reference);
  out += fmt::format("\nbodies              {}\nconstraints         {} ({})\n", check.names.bodies.size(),
                     scene.constraints.size(), joint_summary(scene));
  if (check.rank)
    out += fmt::format("rows, rank          {}, {}\ndegrees of freedom  {}\n", check.rows.size(), *check.rank,
                       *check.degrees_of_freedom);
  else
    out += fmt::format("rows, rank          {}, not determined: the state violates its constraints\n",
                       check.rows.size());
  if (check.condition)
    out += fmt::format("condition number    {:.2e}\n", *check.condition);
  else
    out += fmt::format(
        "condition number    not determined: the scene is too large for the dense solver{}\n",
        check.rank ? fmt::format("; the rank is from the {} solver", check.solver) : std::string());
  if (!check.mu.empty())
    if (const auto [least, most] = std::minmax_element(check.mu.begin(), check.mu.end()); *most > 0)
      out += fmt::format(
          "singular mass       norms use M + Phi_q^T diag(mu) Phi_q instead of M, mu from {:.3g} to {:.3g}\n",
          *least, *most);
  for (const std::string& body : check.unphysical_inertia)
    out += fmt::format("unphysical inertia  body \"{}\", as declared in the scene\n", body);
  if (const auto rows = dependent(); !rows.empty()) {
    out += fmt::format("dependent rows      {}\n", fmt::join(rows, ", "));
    out += fmt::format("lambda not unique   {}\n", fmt::join(not_unique(), ", "));
  }
  double position = 0, velocity = 0;
  for (const RowCheck& row : check.rows) {
    raise(position, row.position_violation);
    raise(velocity, row.velocity_violation);
  }
  out += fmt::format(
      "position violation  {:.2e} m or rad, largest\nvelocity violation  {:.2e} m/s or rad/s, largest\n",
      position, velocity);
  out +=
      fmt::format("energy              kinetic {:.9g} J, potential {:.9g} J, power of the effects {:.9g} W\n",
                  check.kinetic_energy, check.potential_energy, check.effect_power);
  Table table({"augmented matrix", "size", "nonzeros", "percent"});
  for (const Sparsity& s : sparsity)
    table.add(
        {s.name, std::to_string(s.size), std::to_string(s.nonzeros), fmt::format("{:.2f}", s.percent())});
  return out + "\n" + table.text();
}

}  // namespace trivium
