#pragma once
/// The contract of a model with constraints, as implicit and half-explicit methods see it. Its functions form
/// groups, each a concept; a method requires only the groups that it uses:
///
///   displacements.hpp    HasDisplacements: state and displacement
///   residual.hpp         HasResidual: the equations of motion at a state
///   newton_matrix.hpp    HasNewtonMatrix: linear systems
///   internal_rows.hpp    HasInternalRows: rows that a model handles itself, such as |p| = 1
///   springs.hpp          HasSprings: stiffness and damping, for methods of several stages
///
/// integrators/contract/spherical_pendulum.hpp is a one-page model that has all of these functions.

#include "integrators/contract/internal_rows.hpp"
#include "integrators/contract/springs.hpp"

namespace trivium::integrators {

/// A system with all groups of functions.
template <class System>
concept ConstrainedSystem = HasSprings<System> && HasInternalRows<System>;

}  // namespace trivium::integrators
