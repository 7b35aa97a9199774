#pragma once
/// Where the mass matrix that Simbody inverts is singular. Simbody notices only where it is so to the last
/// bit; where rounding leaves it barely regular, it answers with noise. So the scene decides.

#include <optional>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace trivium {

/// A body that turns about an axis without inertia (a principal moment within 1e-12 of the trace) while
/// nothing with mass moves, in the tree of the joints that are mobilizers: its name; nothing where there is
/// none.
///
/// With Z the rotations about the axes without inertia and Phi_t the rows of the tree's joints, such a motion
/// is a w that is not 0 with Phi_t Z w = 0. What closes the tree does not count: Simbody inverts the tree's
/// mass matrix before it looks at constraints. `Phi` is the tangent Jacobian of all rows.
std::optional<std::string> massless_motion(const Mechanism<double>& mechanism, const MatrixX<double>& Phi,
                                           const std::vector<int>& mobilizers);

}  // namespace trivium
