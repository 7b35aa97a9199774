#pragma once
/// The vector type of methods: a state y, its rate or a change of it. The system alone knows which element
/// means what (simulation/system/state_layout.hpp).

#include <Eigen/Core>

namespace trivium::integrators {

template <class S>
using StateVector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

}  // namespace trivium::integrators
