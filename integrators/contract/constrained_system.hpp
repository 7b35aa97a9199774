#pragma once
/// A model with its constraints: all groups of demands that implicit and half-explicit methods have, each a
/// concept of its own. A method names those that it needs:
///
///   displacements.hpp    HasDisplacements: state and displacement
///   residual.hpp         HasResidual: the equations of motion at a state
///   newton_matrix.hpp    HasNewtonMatrix: linear systems
///   internal_rows.hpp    HasInternalRows: rows that a model keeps to itself
///   springs.hpp          HasSprings: stiffness and damping, for methods of several stages
///
/// integrators/contract/spherical_pendulum.hpp is a model of one page that has them all.

#include "integrators/contract/internal_rows.hpp"
#include "integrators/contract/springs.hpp"

namespace trivium::integrators {

template <class System>
concept ConstrainedSystem = HasSprings<System> && HasInternalRows<System>;

}  // namespace trivium::integrators
