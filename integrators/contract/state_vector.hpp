#pragma once
/// The numbers of a state, or of a rate or change of one, as methods see them. Where each number stands is
/// the system's (simulation/system/state_layout.hpp).

#include <Eigen/Core>

namespace trivium::integrators {

template <class S>
using StateVector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

}  // namespace trivium::integrators
