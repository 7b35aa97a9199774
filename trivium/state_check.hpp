#pragma once
/// Checks of a scene's state before it is solved or simulated, and the warnings about a solution. The public
/// interface and the program share them. Only the library's own sources include this header.

#include <filesystem>
#include <string>

#include "base/error.hpp"
#include "formulations/side_by_side.hpp"
#include "mechanism/model.hpp"
#include "scenes/scene.hpp"
#include "trivium/solve.hpp"

namespace trivium {

/// The analysis behind trivium::check and `trivium check`.
Check check_state(const scenes::Scene& scene, const Model<double>& model);

/// Throws an Error of kind input, with the violated rows and advice, if the state violates its constraints.
/// If the state is the end of a `saved` run, the advice says that the errors of that run may be the cause.
void require_consistent(const std::string& source, const Model<double>& model,
                        const std::optional<SavedRun>& saved);
/// The same for the start of a simulation in `formulation`. If the state is the end of a saved run in that
/// formulation, it may violate its rows by ten times what that run reported, plus 1e-12 (the run scales rows
/// in another way). Index-3 methods leave such
/// violations of the velocity rows.
void require_consistent(const std::string& source, const Model<double>& model,
                        const std::optional<SavedRun>& saved, const std::string& formulation);

/// A state solved in the chosen formulations, by the dense solver or, if the mechanism is too large for that,
/// by the structured one.
struct SolvedState {
  const char* solver;  ///< "printed" or "structured"
  SideBySide<double> answer;
};
/// Solves the state of a model in the formulations of `options`.
SolvedState solve_state(const scenes::Scene& scene, const Model<double>& model, const SolveOptions& options);

/// Warnings about a solution: large estimated errors, equations of motion with a large residual, rows
/// for which the rank tolerance decides narrowly, bodies that declare an unphysical inertia.
template <class Scalar>
std::vector<std::string> warnings_of(const scenes::Scene& scene, const SideBySide<Scalar>& answer);

/// Returns the result of `work`. An Error thrown by `work` gets the source of the scene in front; a
/// filesystem_error becomes an Error of kind input.
template <class Work>
auto naming_errors(const std::string& source, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(source, error);
  } catch (const std::filesystem::filesystem_error& error) {
    throw Error(source, Error(ErrorKind::input, error.what()));
  }
}

}  // namespace trivium
