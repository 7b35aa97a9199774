#pragma once
/// A scene at one state: its rank, consistency and energy (check), the projection of the state onto the
/// constraints (assemble), and accelerations, multipliers and reactions (solve). Checks, warnings and numbers
/// are those of the programs `trivium check` and `trivium solve`.

#include <optional>
#include <string>
#include <vector>

#include "trivium/instant.hpp"

namespace trivium {

/// One row of the constraints at a state.
struct RowCheck {
  /// Phi [unit of the row: m for cd and dp2 of a unit vector, m^2 for d, - for dp1]. If a scene multiplies
  /// the row by a factor, both residuals contain this factor.
  double position_residual = 0;
  double velocity_residual = 0;  ///< Phi_q q' - nu [unit of the row per s]
  /// The magnitude of position_residual, divided by the norm of the row's gradient [m or rad]. For a row of
  /// lengths, the rotational part of the gradient is divided by the length of the mechanism
  /// (Check::is_consistent), so that all parts of the norm have one unit. For a row of angles (dp1,
  /// rotation_driver), the norm contains the rotational part only. A factor of the row does not change the
  /// violations, since the gradient contains it too.
  double position_violation = 0;
  double velocity_violation = 0;  ///< the same for velocity_residual [m/s or rad/s]
  bool is_unique = true;          ///< its multiplier is unique; not determined if Check::rank is empty
  /// The row is one of the nc - rank rows that are called dependent, because they follow from the others.
  /// Which ones is a convention: as far as possible the last ones. Not determined if Check::rank is empty.
  bool is_dependent = false;
};

/// The result of check().
struct Check {
  std::string scene;           ///< name of the scene
  std::string solver;          ///< "printed" (dense), or "structured" above 6000 unknowns (6 nb + nc)
  Names names;                 ///< names of bodies, joints and rows
  double t = 0;                ///< time of the state [s]
  std::vector<RowCheck> rows;  ///< [nc], in the order of names.rows
  /// Rank of Phi_q [-]. None from the structured solver if the state is not consistent (is_consistent).
  std::optional<int> rank;
  std::optional<int> degrees_of_freedom;  ///< 6 nb - rank [-]; none if there is no rank
  /// kappa [-], condition number of E^-1 Phi_q M^-1 Phi_q^T E^-1 over its nonzero singular values, where E^2
  /// = diag(Phi_q M^-1 Phi_q^T); M and Phi_q are those of r-omega. None from the structured solver.
  std::optional<double> condition;
  /// Weights mu_k of the rows [nc], all 0 if M is regular. If M is singular, as for point masses, norms use
  /// the regular matrix M + Phi_q^T diag(mu) Phi_q instead of M; the term of row k is then about as large as
  /// the inertia of the lighter of its two bodies. The unit of mu_k is kg m^2 divided by the square of the
  /// unit of Phi: kg for rows in m (cd, dp2 of a unit vector), kg m^2 for dp1 of unit vectors, kg/m^2 for d.
  /// Empty if the structured solver does not compute the weights.
  std::vector<double> mu;
  std::vector<std::string> contradictory;  ///< dependent rows that contradict those on which they depend
  std::vector<std::string> warnings;       ///< rows for which the rank tolerance decides narrowly
  /// Joints on a wrong branch (antiparallel axes, opposite x axes, an angle half a turn from the driven one),
  /// and why.
  std::vector<std::string> wrong_branches;
  std::vector<std::string> unphysical_inertia;  ///< bodies that declare an unphysical inertia
  /// Whether the state satisfies its constraints. Every position_violation must be at most 1e-8 times the
  /// length of the mechanism; for rows of angles, 1e-8 rad. Every velocity_violation must be at most 1e-8
  /// times the speed of the mechanism plus 1e-12 1/s times its length; for rows of angles, both divided by
  /// this length. No joint may be on a wrong branch. The length is the largest distance of a centre of mass
  /// from the global origin or of a joint point from the origin of its body, 1 m if all are 0. The speed is
  /// the largest velocity, or angular velocity times length.
  bool is_consistent = false;
  std::string inconsistency;  ///< the violated rows and branches, one per line; empty if none
  double kinetic_energy = 0;  ///< of all bodies [J]
  /// Energy stored by the effects [J]. That of gravity is 0 for a body whose centre of mass is at the global
  /// origin, that of a spring is 0 at its free length or angle. A force F with constant global components has
  /// -F . r_P with its point P; other loads have none.
  double potential_energy = 0;
  double effect_power = 0;  ///< power of all effects on the bodies [W]
};

/// Analyses a state, whether it satisfies its constraints or not. Throws an Error: of kind input if the scene
/// is wrong, of kind model if its rows cannot be analysed at this state.
Check check(const Scene& scene);

/// A copy of the scene whose state satisfies its constraints: positions, then velocities, are projected by
/// the least change in the metric of the mass matrix. Throws an Error: of kind input if the scene is wrong,
/// of kind model, which names the rows, if rows cannot be met.
Scene assemble(const Scene& scene);

/// Settings of solve() and solve_in_all().
struct SolveSettings {
  std::string formulation = "r-omega";  ///< one of formulation_names(); solve_in_all ignores it
  std::string sequence = "313";         ///< sequence of the Euler angles of r-epsilon
  bool reframe = true;                  ///< take another chart if the sequence is near its singularity
};

/// Accelerations, multipliers and reactions at a state, in one formulation.
struct Solution : Instant {
  std::string formulation;             ///< name of the formulation
  std::string solver;                  ///< "printed" or "structured", as in Check
  std::vector<double> lambda_p;        ///< r-p: [nb], multipliers of (p . p - 1)/2 = 0 [N m]; otherwise empty
  std::optional<double> condition;     ///< kappa [-], as in Check
  std::vector<std::string> dependent;  ///< names of the rows that are dependent at this state
  /// Uncertain numbers, unmet equations, rows near the rank tolerance, unphysical inertias.
  std::vector<std::string> warnings;
};

/// Solves the equations of motion at the scene's state. Throws an Error: of kind input if the state violates
/// its constraints or a setting is wrong, of kind model if the formulation has no solution there.
Solution solve(const Scene& scene, const SolveSettings& settings = {});

/// A state solved in every formulation.
struct Solutions {
  std::vector<Solution> solved;     ///< one per formulation that has a solution
  std::vector<std::string> failed;  ///< "formulation: reason", one per formulation that has no solution
  /// Largest relative difference of lambda between two formulations [-], as in ComparedOutput. This and the
  /// next two are NaN if their norm is not known.
  double lambda_difference = 0;
  /// Largest difference of r'' between two formulations in the metric of the mass matrix [-]. It is relative
  /// to all accelerations, r'' and omega_bar' together, or to those that the magnitudes of Q and gamma would
  /// cause if these are larger.
  double r_ddot_difference = 0;
  /// Largest relative difference of omega_bar' between two formulations, in the same way [-].
  double omega_bar_dot_difference = 0;
  std::optional<double> lambda_bound;  ///< of lambda_difference: 100 u kappa [-]; none if kappa is not known
};

/// Solves in every formulation. Throws as solve() does, except for a formulation without solution:
/// Solutions::failed lists it.
Solutions solve_in_all(const Scene& scene, const SolveSettings& settings = {});

/// The names of the formulations, as SolveSettings::formulation accepts them. Throws no Error.
std::vector<std::string> formulation_names();

}  // namespace trivium
