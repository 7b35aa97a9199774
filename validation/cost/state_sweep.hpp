#pragma once
/// Our solver over many states of one mechanism: one by one, or as many at once as a vector register holds
/// numbers (bodies/numbers/batch.hpp). Both give the same accelerations.

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
  std::function<void()> all;                        ///< solves at all that were taken
  std::function<std::vector<Vector3>(int)> r_ddot;  ///< at one of them
};

inline constexpr int register_lanes = native_lanes<double>;

/// In the formulation of that name; throws a ModelError where there is none.
StateSweep one_by_one(const Mechanism<double>& mechanism, const std::string& formulation, Refined refined);
/// `register_lanes` at once; the states' number is a multiple of that.
StateSweep in_batches(const Mechanism<double>& mechanism, const std::string& formulation, Refined refined);

}  // namespace trivium::cost
