/// trivium check: what a scene consists of, and whether its state holds together.

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "base/exit_code.hpp"
#include "base/json_writer.hpp"
#include "base/table.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/printed/sparsity.hpp"
#include "scenes/format/scene_keys.hpp"
#include "scenes/make_mechanism.hpp"
#include "trivium/command/commands.hpp"
#include "trivium/command/scene_argument.hpp"

namespace trivium {

namespace {

struct CheckArguments : SceneArguments {
  bool json = false;
};

struct Energy {
  double kinetic = 0, potential = 0, power = 0;
};

Energy energy_of(const Mechanism<double>& mechanism, const MechanismState<double>& state) {
  using F = ROmega<double>;
  const auto body = body_kinematics(to_coordinates<F>(mechanism, state, {}));
  const std::vector<BodyMotion<double>> motion(body.begin(), body.end());
  const EffectView<double> view{mechanism.bodies, motion, state.t};
  Energy e{0, mechanism.effects.potential_energy(view), mechanism.effects.power(view)};
  for (int b = 0; b < mechanism.nb(); ++b) e.kinetic += kinetic_energy(mechanism.bodies[b], state.twist[b]);
  return e;
}

std::string joint_summary(const scenes::Scene& scene) {
  std::string out;
  for (const scenes::ConstraintShape& known : scenes::constraint_shapes) {
    const auto count = std::count_if(scene.constraints.begin(), scene.constraints.end(),
                                     [&](const scenes::Constraint& c) { return c.type == known.type; });
    if (count > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, known.shape.name());
  }
  return out.empty() ? "none" : out;
}

double worst(const std::vector<Violation>& violations) {
  double size = 0;
  for (const Violation& v : violations) size = std::max(size, v.size);
  return size;
}

struct Report {
  const CheckArguments& arguments;
  const scenes::Scene& scene;
  const Mechanism<double>& mechanism;
  const std::optional<RowAnalysis>& analysis;  ///< none where it would be too large
  const Consistency& consistency;
  const Energy& energy;
  const std::vector<Sparsity>& sparsity;

  std::vector<std::string> names(bool (*chosen)(const RowAnalysis&, int)) const {
    std::vector<std::string> out;
    if (!analysis) return out;
    for (int k = 0; k < mechanism.nc(); ++k)
      if (chosen(*analysis, k)) out.push_back(mechanism.row_names[k]);
    return out;
  }
  std::vector<std::string> redundant() const {
    return names([](const RowAnalysis& r, int k) {
      return std::find(r.dependent.begin(), r.dependent.end(), k) != r.dependent.end();
    });
  }
  std::vector<std::string> not_unique() const {
    return names([](const RowAnalysis& r, int k) { return !r.unique[k]; });
  }
  std::vector<std::string> contradictory() const {
    return names([](const RowAnalysis& r, int k) {
      return std::find(r.contradictory.begin(), r.contradictory.end(), k) != r.contradictory.end();
    });
  }
  std::vector<std::string> unphysical() const {
    std::vector<std::string> out;
    for (const scenes::Body& body : scene.bodies)
      if (body.unphysical_inertia) out.push_back(body.name);
    return out;
  }

  std::string json() const;
  std::string text() const;
};

std::string Report::json() const {
  JsonWriter json;
  json.begin_object()
      .text("scene", scene.name)
      .number("t", arguments.t)
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

std::string Report::text() const {
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
      worst(consistency.positions), worst(consistency.velocities));
  out +=
      fmt::format("energy              kinetic {:.9g} J, potential {:.9g} J, power of the effects {:.9g} W\n",
                  energy.kinetic, energy.potential, energy.power);
  Table table({"augmented matrix", "size", "nonzeros", "percent"});
  for (const Sparsity& s : sparsity)
    table.add(
        {s.name, std::to_string(s.size), std::to_string(s.nonzeros), fmt::format("{:.2f}", s.percent())});
  return out + "\n" + table.text();
}

int run_check(const CheckArguments& arguments) {
  const scenes::Scene scene = load_state(arguments);
  const auto model = make_model<double>(scene, arguments.t);
  const auto& [mechanism, state] = model;
  const Consistency consistency = check_consistency(mechanism, state);
  // the rank is decided on the dense Jacobian; all else that is reported is sparse
  const int unknowns = 6 * mechanism.nb() + mechanism.nc();
  std::optional<RowAnalysis> rows;
  if (unknowns <= most_dense_unknowns)
    rows = analyse_rows(tangent_system(mechanism, state));
  else
    fmt::print(stderr,
               "warning: {}: rank and redundant rows are not determined: a dense analysis of {} unknowns, "
               "beyond the {} that it is done for\n",
               arguments.scene, unknowns, most_dense_unknowns);
  const Report report{
      arguments, scene, mechanism, rows, consistency, energy_of(mechanism, state), augmented_sparsity(model)};
  fmt::print("{}", arguments.json ? report.json() : report.text());
  if (rows && !rows->contradictory.empty()) {
    fmt::print(stderr, "error: {}: no acceleration satisfies all rows: {} against the rows before\n",
               arguments.scene, fmt::join(report.contradictory(), ", "));
    return exit_input_error;
  }
  return report_consistency(arguments, consistency) ? exit_done : exit_input_error;
}

}  // namespace

Command add_check_command(ProgramOptions& program) {
  auto arguments = std::make_shared<CheckArguments>();
  ProgramOptions options =
      program.add_subcommand("check", "Rank, redundant rows, residuals, energy and sparsity of a scene");
  add_scene_options(options, *arguments);
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options, [arguments] { return naming_scene(*arguments, [&] { return run_check(*arguments); }); }};
}

}  // namespace trivium
