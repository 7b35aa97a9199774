/// trivium solve: accelerations, lambda and reactions of a scene's state, in every formulation.

#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "base/exit_code.hpp"
#include "base/json_writer.hpp"
#include "base/number_text.hpp"
#include "base/table.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/side_by_side.hpp"
#include "scenes/make_mechanism.hpp"
#include "trivium/command/commands.hpp"
#include "trivium/command/scene_argument.hpp"

namespace trivium {

namespace {

struct SolveArguments : SceneArguments {
  std::string formulation = "all", sequence = "313", scalar = "double";
  bool raw_chart = false, json = false;
};

/// An estimated error above this is warned about.
constexpr double warn_above = 1e-6;

template <class Scalar>
struct Report {
  const SolveArguments& arguments;
  const scenes::Scene& scene;
  const Mechanism<Scalar>& mechanism;
  const SideBySide<Scalar>& result;

  int dof() const { return 6 * mechanism.nb() - result.rows.rank; }
  std::vector<std::string> warnings() const;
  std::string json() const;
  std::string text() const;

 private:
  void write_formulation(JsonWriter& json, const FormulationResult<Scalar>& f) const;
  std::string lambda_table() const;
  std::string acceleration_table() const;
  std::string reaction_table() const;
  std::vector<const FormulationResult<Scalar>*> solved() const;
};

template <class Scalar>
std::vector<std::string> Report<Scalar>::warnings() const {
  std::vector<std::string> out;
  for (const auto& f : result.formulations) {
    if (!f.error.empty()) out.push_back(fmt::format("{}: not solved: {}", f.name, f.error));
    if (f.estimate.lambda > warn_above)
      out.push_back(
          fmt::format("{}: lambda is uncertain: estimated relative error {:.1e}", f.name, f.estimate.lambda));
    if (f.estimate.acceleration > warn_above)
      out.push_back(fmt::format("{}: accelerations are uncertain: estimated relative error {:.1e}", f.name,
                                f.estimate.acceleration));
    const double residual = std::max(f.residual.bodies, f.residual.rows);
    if (f.error.empty() && residual > 1e-6 && residual > 1e6 * static_cast<double>(unit_roundoff<Scalar>()))
      out.push_back(
          fmt::format("{}: the matrix-free equations are not met: residual {:.1e}", f.name, residual));
  }
  for (const scenes::Body& body : scene.bodies)
    if (body.unphysical_inertia)
      out.push_back(fmt::format("body \"{}\" declares an unphysical inertia", body.name));
  return out;
}

template <class Scalar>
std::vector<const FormulationResult<Scalar>*> Report<Scalar>::solved() const {
  std::vector<const FormulationResult<Scalar>*> out;
  for (const auto& f : result.formulations)
    if (f.error.empty()) out.push_back(&f);
  return out;
}

template <class Vectors>
void write_vectors(JsonWriter& json, std::string_view key, const Vectors& vectors) {
  json.begin_array(key);
  for (const auto& v : vectors) json.numbers({}, v);
  json.end_array();
}

template <class Scalar>
void Report<Scalar>::write_formulation(JsonWriter& json, const FormulationResult<Scalar>& f) const {
  json.begin_object().text("name", f.name);
  if (!f.error.empty()) {
    json.text("error", f.error).end_object();
    return;
  }
  json.numbers("lambda", f.solution.lambda).flags("lambda_unique", result.rows.unique);
  write_vectors(json, "r_ddot", f.solution.r_ddot);
  write_vectors(json, "omega_bar_dot", f.solution.omega_bar_dot);
  if (f.lambda_internal.size() > 0) json.numbers("lambda_p", f.lambda_internal);
  json.number("lambda_error_estimate", f.estimate.lambda)
      .number("acceleration_error_estimate", f.estimate.acceleration)
      .number("matrix_free_residual", std::max(f.residual.bodies, f.residual.rows));
  if (!f.charts.empty()) json.texts("charts", f.charts);
  json.begin_array("reactions");
  for (std::size_t k = 0; k < f.reactions.size(); ++k)
    json.begin_object()
        .text("joint", mechanism.joints[k].name)
        .text("body", mechanism.body_names[mechanism.joints[k].j])
        .numbers("force", f.reactions[k].force)
        .numbers("torque", f.reactions[k].torque)
        .end_object();
  json.end_array().end_object();
}

template <class Scalar>
std::string Report<Scalar>::json() const {
  JsonWriter json;
  json.begin_object()
      .text("scene", scene.name)
      .number("t", arguments.t)
      .text("scalar", arguments.scalar)
      .number("nb", mechanism.nb())
      .number("nc", mechanism.nc())
      .number("dof", dof())
      .number("rank", result.rows.rank);
  json.begin_array("formulations");
  for (const auto& f : result.formulations) write_formulation(json, f);
  json.end_array();
  const Discrepancy d = result.discrepancy();
  json.begin_object("discrepancy")
      .number("lambda", d.lambda)
      .number("r_ddot", d.r_ddot)
      .number("omega_bar_dot", d.omega_bar_dot)
      .end_object();
  json.number("condition", result.rows.kappa).texts("rows", mechanism.row_names);
  std::vector<std::string> redundant;
  for (int k : result.rows.dependent) redundant.push_back(mechanism.row_names[k]);
  json.texts("redundant", redundant).texts("warnings", warnings()).end_object();
  return json.str();
}

template <class Scalar>
std::string Report<Scalar>::lambda_table() const {
  std::vector<std::string> header{"row"};
  for (const auto* f : solved()) header.push_back(f->name);
  header.push_back("");
  Table table(header);
  for (int k = 0; k < mechanism.nc(); ++k) {
    std::vector<std::string> row{mechanism.row_names[k]};
    for (const auto* f : solved()) row.push_back(number_text(f->solution.lambda[k]));
    row.push_back(result.rows.unique[k] ? "" : "not unique");
    table.add(row);
  }
  return table.text();
}

template <class Scalar>
std::string Report<Scalar>::acceleration_table() const {
  Table table(
      {"body", "formulation", "r''_x", "r''_y", "r''_z", "omega_bar'_x", "omega_bar'_y", "omega_bar'_z"});
  for (int b = 0; b < mechanism.nb(); ++b)
    for (const auto* f : solved()) {
      std::vector<std::string> row{f == solved().front() ? mechanism.body_names[b] : "", f->name};
      for (const Scalar& x : f->solution.r_ddot[b]) row.push_back(number_text(x));
      for (const Scalar& x : f->solution.omega_bar_dot[b]) row.push_back(number_text(x));
      table.add(row);
    }
  return table.text();
}

template <class Scalar>
std::string Report<Scalar>::reaction_table() const {
  const FormulationResult<Scalar>& f = *solved().front();
  Table table({"joint", "on body", "F_x", "F_y", "F_z", "T_x", "T_y", "T_z"});
  for (std::size_t k = 0; k < f.reactions.size(); ++k) {
    std::vector<std::string> row{mechanism.joints[k].name, mechanism.body_names[mechanism.joints[k].j]};
    for (const Scalar& x : f.reactions[k].force) row.push_back(fmt::format("{:.9g}", static_cast<double>(x)));
    for (const Scalar& x : f.reactions[k].torque)
      row.push_back(fmt::format("{:.9g}", static_cast<double>(x)));
    table.add(row);
  }
  return table.text();
}

template <class Scalar>
std::string Report<Scalar>::text() const {
  std::string out = fmt::format(
      "{}: t = {}, {}, {} of rank {}, {}, condition {:.1e}\n", scene.name, arguments.t,
      counted(mechanism.bodies.size(), "body", "bodies"), counted(mechanism.rows.size(), "row", "rows"),
      result.rows.rank, counted(static_cast<std::size_t>(dof()), "degree of freedom", "degrees of freedom"),
      result.rows.kappa);
  if (solved().empty()) return out;
  if (mechanism.nc() > 0) out += "\nlambda\n" + lambda_table();
  out += "\naccelerations [m/s^2, global; rad/s^2, body frame]\n" + acceleration_table();
  if (mechanism.nc() > 0)
    out += fmt::format("\nreactions on body j [N, N m; global frame, about the joint's point on i] ({})\n",
                       solved().front()->name) +
           reaction_table();
  Table estimates({"formulation", "error of lambda", "of accelerations", "matrix-free residual", "charts"});
  for (const auto* f : solved())
    estimates.add({f->name, fmt::format("{:.1e}", f->estimate.lambda),
                   fmt::format("{:.1e}", f->estimate.acceleration),
                   fmt::format("{:.1e}", std::max(f->residual.bodies, f->residual.rows)),
                   f->charts.empty() ? "-" : fmt::format("{}", fmt::join(f->charts, ", "))});
  out += "\nestimated relative errors\n" + estimates.text();
  if (solved().size() > 1) {
    const Discrepancy d = result.discrepancy();
    out += fmt::format(
        "\nlargest difference between formulations: lambda {}, r'' {:.1e}, omega_bar' {:.1e}\n",
        result.any_unique() ? fmt::format("{:.1e}", d.lambda) : "none", d.r_ddot, d.omega_bar_dot);
  }
  if (!result.rows.dependent.empty()) {
    out += "redundant rows (they follow from the others):";
    for (int k : result.rows.dependent) out += " " + mechanism.row_names[k];
    out +=
        "\nmultipliers marked \"not unique\" are the ones of minimum |E lambda|, E^2 = diag(Phi M^-1 "
        "Phi^T)\n";
  }
  return out;
}

template <class Scalar>
int solve(const SolveArguments& arguments, const scenes::Scene& scene, const Model<Scalar>& model,
          const RowAnalysis& rows, const SolveOptions& options) {
  using Higher = NextPrecisionT<Scalar>;
  const auto judge = make_model(scene, Higher(arguments.t));
  const SideBySide<Scalar> result = side_by_side(model, rows, options, &judge);
  const Report<Scalar> report{arguments, scene, model.mechanism, result};
  for (const std::string& warning : report.warnings()) fmt::print(stderr, "warning: {}\n", warning);
  fmt::print("{}", arguments.json ? report.json() : report.text());
  const bool any = std::any_of(result.formulations.begin(), result.formulations.end(),
                               [](const auto& f) { return f.error.empty(); });
  return any ? exit_done : exit_solver_failed;
}

int run_solve(const SolveArguments& arguments) {
  const scenes::Scene scene = load_state(arguments);
  const auto model = make_model<double>(scene, arguments.t);
  if (!report_consistency(arguments, consistency_of(model))) return exit_input_error;
  SolveOptions options;
  if (arguments.formulation != "all") options.formulations = {arguments.formulation};
  options.charts = {*parse_euler_sequence(arguments.sequence), !arguments.raw_chart};
  const RowAnalysis rows = analyse_rows(model);
  const auto solve_in = [&]<class Scalar>(Scalar t) {
    return solve(arguments, scene, make_model(scene, t), rows, options);
  };
  if (arguments.scalar == "double") return solve(arguments, scene, model, rows, options);
  if (arguments.scalar == "float") return solve_in(static_cast<float>(arguments.t));
  if (arguments.scalar == "quad") return solve_in(Quad(arguments.t));
  return solve_in(Real50(arguments.t));
}

}  // namespace

Command add_solve_command(ProgramOptions& program) {
  auto arguments = std::make_shared<SolveArguments>();
  ProgramOptions options = program.add_subcommand(
      "solve", "Accelerations, lambda and reactions of a scene's state, in every formulation");
  add_scene_options(options, *arguments);
  std::vector<std::string> formulations = formulation_names();
  formulations.push_back("all");
  options.add_option("--formulation", &arguments->formulation, "Which formulation")
      .one_of(formulations)
      .show_default();
  options.add_option("--sequence", &arguments->sequence, "Euler-angle sequence of r-epsilon")
      .one_of({euler_sequence_names.begin(), euler_sequence_names.end()})
      .show_default();
  options.add_flag("--no-reframe", &arguments->raw_chart,
                   "Take the raw chart of the sequence, however near its singularity");
  options.add_option("--scalar", &arguments->scalar, "Arithmetic")
      .one_of({"float", "double", "quad", "50"})
      .show_default();
  options.add_flag("--json", &arguments->json, "JSON on stdout");
  return {options, [arguments] { return naming_scene(*arguments, [&] { return run_solve(*arguments); }); }};
}

}  // namespace trivium
