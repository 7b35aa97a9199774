#pragma once
/// Tests with a method as parameter: the formulations that go with it, its options, its name. For tests only.

#include <algorithm>
#include <string>
#include <vector>

#include "validation/testing/catalogue_motion.hpp"

namespace trivium::test {

/// Options for a method: tolerances if it chooses its steps, else given steps.
inline SimulationOptions options_for(const integrators::MethodInfo& method, const std::string& formulation,
                                     double end) {
  const std::string name(method.name);
  return method.chooses_steps ? tight(formulation, name, end, 1e-8) : stepping(formulation, name, end, 1e-3);
}

inline std::vector<std::string> formulations_of(const integrators::MethodInfo& method) {
  if (method.needs_constant_inertia) return {"r-omega", "r-epsilon-omega-first"};
  return {"r-omega", "r-p", "r-epsilon", "r-epsilon-omega-first"};
}

inline std::string method_in_a_name(const testing::TestParamInfo<integrators::MethodInfo>& method) {
  std::string name(method.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace trivium::test
