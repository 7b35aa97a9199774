#pragma once
/// A scene at one state: whether it holds together, and its accelerations and lambda. Both are those of the
/// programs `trivium check` and `trivium solve`, with the same checks and warnings.

#include <optional>
#include <string>
#include <vector>

#include "trivium/instant.hpp"

namespace trivium {

/// A row of the constraints at a state. A violation is in m or rad (per second), whatever the row's scaling.
struct RowCheck {
  double position_residual = 0, velocity_residual = 0;    ///< Phi, and Phi_q q' - nu
  double position_violation = 0, velocity_violation = 0;  ///< their sizes [m or rad, per second]
  bool is_unique = true;                                  ///< its multiplier
  bool is_redundant = false;                              ///< it follows from other rows
};

struct Check {
  std::string scene, solver;  ///< solver: "printed" (dense), or "structured" beyond what that is done for
  Names names;
  double t = 0;
  std::vector<RowCheck> rows;
  /// None where the structured solver cannot decide the rank, as the state misses its rows.
  std::optional<int> rank, degrees_of_freedom;
  std::optional<double> condition;  ///< kappa of Phi M^-1 Phi^T; none where the solver is the structured one
  std::vector<double> mu;  ///< per row: where M is singular, norms use M + Phi^T diag(mu) Phi; else 0
  std::vector<std::string>
      contradictory;  ///< rows that no acceleration satisfies beside the rows before them
  std::vector<std::string> wrong_branches;  ///< joints whose rows hold on a branch that is not the joint's
  std::vector<std::string> unphysical_inertia;  ///< bodies, by their own word
  bool is_consistent = false;                   ///< positions, velocities and branches hold
  std::string inconsistency;                    ///< what does not, line by line; empty where all holds
  double kinetic_energy = 0, potential_energy = 0, effect_power = 0;  ///< [J, J, W]
};

/// What there is to say of a state, consistent or not. Throws an Error where it cannot be looked at.
Check check(const Scene& scene);

/// The scene with its state projected onto its constraints, positions and then velocities, by the least
/// change in the mass metric. Throws an Error that names the rows that cannot be met.
Scene assemble(const Scene& scene);

struct SolveSettings {
  std::string formulation = "r-omega";  ///< one of formulations()
  std::string sequence = "313";         ///< Euler angles of r-epsilon
  bool reframe = true;                  ///< take another chart where the sequence is near its singularity
};

/// A state solved in one formulation.
struct Solution : Instant {
  std::string formulation, solver;
  std::vector<double> lambda_p;        ///< of r-p, per body; else empty
  std::optional<double> condition;     ///< kappa
  std::vector<std::string> redundant;  ///< rows that follow from others
  std::vector<std::string> warnings;
};

/// Throws an Error: of kind input where the state does not satisfy its constraints.
Solution solve(const Scene& scene, const SolveSettings& settings = {});

/// A state in every formulation.
struct Solutions {
  std::vector<Solution> solved;
  std::vector<std::string> failed;  ///< "formulation: why"
  /// The largest difference between two, relative, in the norm of E and in the mass metric.
  double lambda_difference = 0, r_ddot_difference = 0, omega_bar_dot_difference = 0;
  /// Of lambda's difference: 100 u kappa. None where kappa is not known.
  std::optional<double> lambda_bound;
};

Solutions solve_in_all(const Scene& scene, const SolveSettings& settings = {});

/// The names of the formulations.
std::vector<std::string> formulation_names();

}  // namespace trivium
