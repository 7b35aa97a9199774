#pragma once
/// Assembly: projects a state onto the constraints, first positions, then velocities. The result is the
/// nearest consistent state in the mass metric. No time integration is involved.

#include "formulations/analysis/consistency.hpp"

namespace trivium {

/// Advice in messages about joints on a wrong branch, which projection cannot correct.
inline constexpr const char* wrong_branch_advice =
    "assembly cannot change the branch of a joint: rotate the body by 180 degrees or reverse the axis in the "
    "scene file";

/// The consistent state nearest to `state`: displacements and rotation vectors are weighted by mass and
/// inertia. Dependent rows are allowed. Throws a ModelError that names the rows that cannot be satisfied
/// together.
MechanismState<double> assemble(const Mechanism<double>& mechanism, MechanismState<double> state);

/// Projects the velocities onto Phi_q q' = nu, with the smallest change in the mass metric. Positions are not
/// changed.
void project_velocities(const Mechanism<double>& mechanism, MechanismState<double>& state);

}  // namespace trivium
