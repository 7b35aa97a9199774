/// Chooses the dense or the structured solver by the size of the mechanism, and words the errors and warnings
/// about a state. check_state, the analysis itself, is in check.cpp.

#include "trivium/state_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/assemble.hpp"
#include "formulations/analysis/consistency.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium {

namespace {

/// A residual is also accepted up to 1e6 u: in float (u = 6e-8) rounding alone exceeds uncertain_from, and a
/// wrong matrix leaves residuals near 1.
constexpr double rounding_units = 1e6;

void refuse(const std::string& source, const Model<double>& model, const Consistency& consistency,
            const std::string& about_saved) {
  std::string message = fmt::format("{}: the state at t = {} does not satisfy its constraints:\n{}", source,
                                    model.state.t, consistency.report());
  if (!consistency.holds_rows())
    message += "--assemble projects the state onto its constraints (in C++: assemble)\n";
  if (!consistency.wrong_branches.empty()) message += fmt::format("{}\n", wrong_branch_advice);
  if (consistency.wrong_branches.empty()) message += about_saved;
  while (message.ends_with('\n')) message.pop_back();
  throw Error(ErrorKind::input, message, Place{source, model.state.t});
}

}  // namespace

void require_consistent(const std::string& source, const Model<double>& model,
                        const std::optional<SavedRun>& saved) {
  const Consistency consistency = check_consistency(model.mechanism, model.state);
  if (consistency.holds()) return;
  refuse(source, model, consistency,
         saved
             ? fmt::format("the state was saved by a run with {}, whose errors may cause these violations; a "
                           "simulation in {} continues from the saved state\n",
                           saved->integrator, saved->formulation)
             : "");
}

void require_consistent(const std::string& source, const Model<double>& model,
                        const std::optional<SavedRun>& saved, const std::string& formulation) {
  const Consistency consistency = check_consistency(model.mechanism, model.state);
  if (consistency.holds()) return;
  // The saved violations are measured with other row scales than those here, hence a factor of 10. The floor
  // 1e-12 is the rounding of violations that are zero. A body that was moved by hand within that margin is
  // found later: simulate() compares the saved state vector y with the bodies.
  constexpr double measures = 10, floor = 1e-12;
  if (!saved || saved->formulation != formulation) return require_consistent(source, model, saved);
  const bool is_as_left = consistency.wrong_branches.empty() &&
                          worst_size(consistency.positions) <= saved->phi * measures + floor &&
                          worst_size(consistency.velocities) <= saved->phi_dot * measures + floor;
  if (!is_as_left)
    refuse(
        source, model, consistency,
        "the violations are larger than those that the saved run left: the file was changed; remove its key "
        "\"saved\" to start a new run\n");
}

SolvedState solve_state(const scenes::Scene& scene, const Model<double>& model, const SolveOptions& options) {
  if (is_beyond_dense(model.mechanism)) return {"structured", structured_side_by_side(model, options)};
  using Higher = NextPrecisionT<double>;
  const Model<Higher> judge = make_model(scene, Higher(model.state.t));
  return {"printed", side_by_side(model, analyse_rows(model), options, &judge)};
}

template <class Scalar>
std::vector<std::string> warnings_of(const scenes::Scene& scene, const SideBySide<Scalar>& answer) {
  std::vector<std::string> out;
  for (const auto& f : answer.formulations) {
    if (!f.error.empty()) out.push_back(fmt::format("{}: not solved: {}", f.name, f.error));
    if (!(f.estimate.lambda <= uncertain_from))
      out.push_back(
          fmt::format("{}: lambda is uncertain: estimated relative error {:.1e}", f.name, f.estimate.lambda));
    if (!(f.estimate.acceleration <= uncertain_from))
      out.push_back(fmt::format("{}: accelerations are uncertain: estimated relative error {:.1e}", f.name,
                                f.estimate.acceleration));
    const double residual = f.residual.worst();
    const double rounding = rounding_units * static_cast<double>(unit_roundoff<Scalar>());
    if (f.error.empty() && !(residual <= std::max(uncertain_from, rounding)))
      out.push_back(fmt::format("{}: the equations of motion are not satisfied: matrix-free residual {:.1e}",
                                f.name, residual));
  }
  out.insert(out.end(), answer.rows.warnings.begin(), answer.rows.warnings.end());
  for (const scenes::Body& body : scene.bodies)
    if (body.unphysical_inertia)
      out.push_back(fmt::format("body \"{}\" declares an unphysical inertia", body.name));
  return out;
}

template std::vector<std::string> warnings_of(const scenes::Scene&, const SideBySide<float>&);
template std::vector<std::string> warnings_of(const scenes::Scene&, const SideBySide<double>&);
template std::vector<std::string> warnings_of(const scenes::Scene&, const SideBySide<Quad>&);
template std::vector<std::string> warnings_of(const scenes::Scene&, const SideBySide<Real50>&);

}  // namespace trivium
