#pragma once
/// Many states of one mechanism, as many at once as a vector register holds numbers.

#include <functional>
#include <string>
#include <vector>

#include "bodies/rigid_body.hpp"
#include "scenes/mechanism.hpp"
#include "validation/cost/engine.hpp"

namespace trivium::cost {

struct BatchSweep {
  int lanes = 0;
  std::function<void()> all;
  std::function<std::vector<Vector3>(int)> r_ddot;  ///< at one of the states
};

/// In the formulation of that name. The states' number is a multiple of the lanes'.
BatchSweep batch_sweep(const Mechanism<double>& mechanism, const std::vector<MechanismState<double>>& states,
                       const std::string& formulation, bool refined);

}  // namespace trivium::cost
