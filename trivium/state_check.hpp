#pragma once
/// What the front door and the program ask of a scene's state before they work on it, and how their errors
/// name the scene. The library's own sources include this.

#include <filesystem>
#include <string>

#include "base/error.hpp"
#include "formulations/side_by_side.hpp"
#include "mechanism/model.hpp"
#include "scenes/scene.hpp"
#include "trivium/solve.hpp"

namespace trivium {

/// All that `check` says of a state.
Check check_state(const scenes::Scene& scene, const Model<double>& model);

/// Throws an Error of kind input that says which rows do not hold and what to do.
void require_consistent(const std::string& source, const Model<double>& model,
                        const std::optional<SavedRun>& saved);
/// The same of a state to simulate from: one that a run left may miss its rows by what the run says, as
/// velocities do in methods on index 3, if it goes on in the same numbers.
void require_consistent(const std::string& source, const Model<double>& model,
                        const std::optional<SavedRun>& saved, const std::string& formulation);

/// A state in the formulations asked for, by the dense solver or, for mechanisms too large for it, the
/// structured one.
struct SolvedState {
  const char* solver;  ///< "printed" or "structured"
  SideBySide<double> answer;
};
SolvedState solve_state(const scenes::Scene& scene, const Model<double>& model, const SolveOptions& options);

/// What of an answer deserves a warning: uncertain numbers, equations that are not met, bodies that declare
/// an unphysical inertia.
template <class Scalar>
std::vector<std::string> warnings_of(const scenes::Scene& scene, const SideBySide<Scalar>& answer);

/// What `work` gives; its errors name the scene, and none is of another type than Error.
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
