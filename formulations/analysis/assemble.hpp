#pragma once
/// A state projected onto the constraints, positions first and then velocities: to the nearest state in the
/// mass metric that satisfies them. No integrator is needed for this.

#include "formulations/analysis/consistency.hpp"

namespace trivium {

/// What to do about a wrong branch: to project is none of it.
inline constexpr const char* wrong_branch_advice =
    "a wrong branch cannot be left by projection: turn the body or the axis in the file";

/// Projects positions, then velocities, onto the constraints: to the state nearest the given one,
/// displacements and rotation vectors weighted by mass and inertia; dependent rows are allowed. Throws a
/// ModelError naming the rows that cannot be met together.
MechanismState<double> assemble(const Mechanism<double>& mechanism, MechanismState<double> state);

/// The velocity part alone.
void project_velocities(const Mechanism<double>& mechanism, MechanismState<double>& state);

}  // namespace trivium
