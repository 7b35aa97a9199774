#include "trivium/command/check_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/json_writer.hpp"
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

std::vector<std::string> CheckReport::row_names(bool (*chosen)(const RowAnalysis&, int)) const {
  std::vector<std::string> out;
  if (!analysis) return out;
  for (int k = 0; k < mechanism.nc(); ++k)
    if (chosen(*analysis, k)) out.push_back(mechanism.row_names[k]);
  return out;
}

std::vector<std::string> CheckReport::redundant() const {
  return row_names([](const RowAnalysis& r, int k) {
    return std::find(r.dependent.begin(), r.dependent.end(), k) != r.dependent.end();
  });
}

std::vector<std::string> CheckReport::not_unique() const {
  return row_names([](const RowAnalysis& r, int k) { return !r.unique[k]; });
}

std::vector<std::string> CheckReport::contradictory() const {
  return row_names([](const RowAnalysis& r, int k) {
    return std::find(r.contradictory.begin(), r.contradictory.end(), k) != r.contradictory.end();
  });
}

std::vector<std::string> CheckReport::unphysical() const {
  std::vector<std::string> out;
  for (const scenes::Body& body : scene.bodies)
    if (body.unphysical_inertia) out.push_back(body.name);
  return out;
}

std::string CheckReport::json() const {
  JsonWriter json;
  json.begin_object()
      .text("scene", scene.name)
      .number("t", t)
      .number("nb", mechanism.nb())
      .number("nc", mechanism.nc());
  if (analysis)
    json.number("dof", 6 * mechanism.nb() - analysis->rank)
        .number("rank", analysis->rank)
        .number("condition", analysis->kappa)
        .numbers("mu", analysis->mu)
        .texts("redundant", redundant())
        .texts("not_unique", not_unique())
        .texts("contradictory", contradictory());
  json.texts("unphysical_inertia", unphysical())
      .flag("consistent", consistency.holds())
      .texts("wrong_branches", consistency.wrong_branches)
      .number("kinetic_energy", energy.kinetic)
      .number("potential_energy", energy.potential)
      .number("effect_power", energy.power);
  json.begin_array("rows");
  for (int k = 0; k < mechanism.nc(); ++k) {
    json.begin_object()
        .text("name", mechanism.row_names[k])
        .number("position_residual", consistency.positions[k].residual)
        .number("velocity_residual", consistency.velocities[k].residual);
    if (analysis) json.flag("unique", analysis->unique[k]);
    json.end_object();
  }
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
  out += fmt::format("\nbodies              {}\nconstraints         {} ({})\n", mechanism.nb(),
                     scene.constraints.size(), joint_summary(scene));
  if (analysis)
    out += fmt::format("rows, rank          {}, {}\ndegrees of freedom  {}\ncondition           {:.2e}\n",
                       mechanism.nc(), analysis->rank, 6 * mechanism.nb() - analysis->rank, analysis->kappa);
  else
    out += fmt::format("rows, rank          {}, not determined\n", mechanism.nc());
  if (analysis && analysis->mu.size() > 0 && analysis->mu.maxCoeff() > 0)
    out += fmt::format("singular mass       norms use M + Phi^T diag(mu) Phi, mu from {:.3g} to {:.3g}\n",
                       analysis->mu.minCoeff(), analysis->mu.maxCoeff());
  for (const std::string& body : unphysical())
    out += fmt::format("unphysical inertia  body \"{}\", by its own word\n", body);
  if (analysis && !analysis->dependent.empty()) {
    out += fmt::format("redundant rows      {}\n", fmt::join(redundant(), ", "));
    out += fmt::format("not unique lambda   {}\n", fmt::join(not_unique(), ", "));
  }
  out += fmt::format(
      "position residual   {:.2e} m or rad at worst\nvelocity residual   {:.2e} m/s or rad/s at worst\n",
      worst_size(consistency.positions), worst_size(consistency.velocities));
  out +=
      fmt::format("energy              kinetic {:.9g} J, potential {:.9g} J, power of the effects {:.9g} W\n",
                  energy.kinetic, energy.potential, energy.power);
  Table table({"augmented matrix", "size", "nonzeros", "percent"});
  for (const Sparsity& s : sparsity)
    table.add(
        {s.name, std::to_string(s.size), std::to_string(s.nonzeros), fmt::format("{:.2f}", s.percent())});
  return out + "\n" + table.text();
}

}  // namespace trivium
