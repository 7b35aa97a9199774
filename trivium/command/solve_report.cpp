/// Prints the solutions of one state: lambda and accelerations of every formulation, and the reactions of the
/// first one.

#include "trivium/command/solve_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/number_text.hpp"
#include "base/table.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "bodies/numbers/scalar.hpp"
#include "trivium/state_check.hpp"

namespace trivium {

namespace {

template <class Vectors>
void write_vectors(JsonWriter& json, std::string_view key, const Vectors& vectors) {
  json.begin_array(key);
  for (const auto& v : vectors) json.numbers({}, v);
  json.end_array();
}

}  // namespace

template <class Scalar>
std::vector<const FormulationResult<Scalar>*> SolveReport<Scalar>::solved() const {
  std::vector<const FormulationResult<Scalar>*> out;
  for (const auto& f : result.formulations)
    if (f.error.empty()) out.push_back(&f);
  return out;
}

template <class Scalar>
void SolveReport<Scalar>::write_formulation(JsonWriter& json, const FormulationResult<Scalar>& f) const {
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
      .number("matrix_free_residual", f.residual.worst());
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
std::string SolveReport<Scalar>::json() const {
  JsonWriter json;
  json.begin_object()
      .text("scene", scene.name)
      .number("t", t)
      .text("scalar", scalar)
      .text("solver", solver)
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
  std::vector<std::string> dependent;
  for (int k : result.rows.dependent) dependent.push_back(mechanism.row_names[k]);
  json.texts("dependent", dependent).texts("warnings", warnings_of(scene, result)).end_object();
  return json.str();
}

template <class Scalar>
std::string SolveReport<Scalar>::lambda_table() const {
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
std::string SolveReport<Scalar>::acceleration_table() const {
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
std::string SolveReport<Scalar>::reaction_table() const {
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
std::string SolveReport<Scalar>::text() const {
  std::string out = fmt::format(
      "{}: t = {}, {}, {} of rank {}, {}, condition number {}\n", scene.name, t,
      counted(mechanism.bodies.size(), "body", "bodies"), counted(mechanism.rows.size(), "row", "rows"),
      result.rows.rank, counted(static_cast<std::size_t>(dof()), "degree of freedom", "degrees of freedom"),
      std::isnan(result.rows.kappa) ? "not determined" : fmt::format("{:.1e}", result.rows.kappa));
  if (solver != std::string_view("printed"))
    out += fmt::format("solved by the {} solver: the scene is too large for the dense solver\n", solver);
  if (solved().empty()) return out;
  if (mechanism.nc() > 0) out += "\nlambda\n" + lambda_table();
  out += "\naccelerations [m/s^2, global; rad/s^2, body frame]\n" + acceleration_table();
  if (mechanism.nc() > 0)
    out +=
        fmt::format("\nreactions on body j [N, N m; global frame, about the joint's point on body i] ({})\n",
                    solved().front()->name) +
        reaction_table();
  Table estimates(
      {"formulation", "error of lambda", "error of accelerations", "matrix-free residual", "charts"});
  for (const auto* f : solved())
    estimates.add({f->name, fmt::format("{:.1e}", f->estimate.lambda),
                   fmt::format("{:.1e}", f->estimate.acceleration),
                   fmt::format("{:.1e}", f->residual.worst()),
                   f->charts.empty() ? "-" : fmt::format("{}", fmt::join(f->charts, ", "))});
  out += "\nestimated relative errors\n" + estimates.text();
  const bool has_norms = result.rows.E.size() > 0 || mechanism.nc() == 0;
  if (solved().size() > 1 && !has_norms) {
    out +=
        "\ndifferences between formulations: not determined, since the structured solver has no norm if an "
        "inertia is singular\n";
  } else if (solved().size() > 1) {
    const Discrepancy d = result.discrepancy();
    out += fmt::format(
        "\nlargest difference between formulations: lambda {}, r'' {:.1e}, omega_bar' {:.1e}\n",
        result.any_unique() ? fmt::format("{:.1e}", d.lambda) : "none", d.r_ddot, d.omega_bar_dot);
  }
  if (!result.rows.dependent.empty()) {
    out += "dependent rows (linear combinations of the other rows):";
    for (int k : result.rows.dependent) out += " " + mechanism.row_names[k];
    out += has_norms ? "\nmultipliers marked \"not unique\": the solution of minimum norm |E lambda|, E^2 = "
                       "diag(Phi_q M^-1 Phi_q^T)\n"
                     : "\nmultipliers marked \"not unique\": a solution with 0 in dependent rows\n";
  }
  return out;
}

template struct SolveReport<float>;
template struct SolveReport<double>;
template struct SolveReport<Quad>;
template struct SolveReport<Real50>;

}  // namespace trivium
