#pragma once
/// Detects that the mass matrix that Simbody inverts is singular. Simbody notices this only if the matrix is
/// exactly singular; if rounding leaves the matrix barely regular, Simbody returns noise. The test is
/// therefore made on the scene.

#include <optional>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace trivium {

/// The name of a body that can rotate about an axis without inertia while nothing with mass moves; empty if
/// there is none. An axis has no inertia if the principal moment is at most 1e-12 times the trace. Only the
/// joints in `mobilizers` restrict motions.
///
/// Let Z be the rotations about all axes without inertia, and Phi_t the rows of the mobilizers' joints. Such
/// a motion is a vector w != 0 with Phi_t Z w = 0. Closing joints do not count, because Simbody inverts the
/// mass matrix of the tree before it considers constraints. `Phi` is the Jacobian [Phi_r, Phi_pi_bar] of all
/// rows.
std::optional<std::string> massless_motion(const Mechanism<double>& mechanism, const MatrixX<double>& Phi,
                                           const std::vector<int>& mobilizers);

}  // namespace trivium
