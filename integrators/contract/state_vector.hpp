#pragma once
/// The vector type of methods. The system defines the meaning of its elements
/// (simulation/system/state_layout.hpp).

#include <Eigen/Core>

namespace trivium::integrators {

/// A state y, its rate or a change of it.
template <class S>
using StateVector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

}  // namespace trivium::integrators
