#pragma once
/// Trivium's solver over many states of one mechanism: one state at a time, or as many at once as a vector
/// register holds numbers (bodies/numbers/batch.hpp). Both give the same accelerations.

#include <functional>
#include <string>
#include <vector>

#include "bodies/numbers/batch.hpp"
#include "bodies/rigid_body.hpp"
#include "mechanism/mechanism.hpp"
#include "validation/cost/trivium_engines.hpp"

namespace trivium::cost {

using States = std::vector<MechanismState<double>>;

struct StateSweep {
  std::function<void(const States&)> take;
  std::function<void()> all;                        ///< solves all states of the last take()
  std::function<std::vector<Vector3>(int)> r_ddot;  ///< solution at one of these states
};

inline constexpr int register_lanes = native_lanes<double>;

/// Solves one state at a time. Throws a ModelError if there is no formulation with this name.
StateSweep one_by_one(const Mechanism<double>& mechanism, const std::string& formulation, Refined refined);
/// Solves `register_lanes` states at once. The number of states must be a multiple of register_lanes.
StateSweep in_batches(const Mechanism<double>& mechanism, const std::string& formulation, Refined refined);

}  // namespace trivium::cost
