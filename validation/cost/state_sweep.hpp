#pragma once
/// Our solver over many states of one mechanism, one by one or as many at once as a vector register holds
/// numbers.

#include <functional>
#include <string>
#include <vector>

#include "bodies/batch.hpp"
#include "bodies/rigid_body.hpp"
#include "scenes/mechanism.hpp"
#include "validation/cost/ours.hpp"

namespace trivium::cost {

struct StateSweep {
  std::function<void()> all;
  std::function<std::vector<Vector3>(int)> r_ddot;  ///< at one of the states
};

inline constexpr int register_lanes = native_lanes<double>;

/// In the formulation of that name.
StateSweep one_by_one(const Mechanism<double>& mechanism, const std::vector<MechanismState<double>>& states,
                      const std::string& formulation, Refined refined);
/// `register_lanes` at once; the states' number is a multiple of that.
StateSweep in_batches(const Mechanism<double>& mechanism, const std::vector<MechanismState<double>>& states,
                      const std::string& formulation, Refined refined);

}  // namespace trivium::cost
