#include "formulations/side_by_side.hpp"

#include "formulations/r_epsilon_omega_first.hpp"
#include "formulations/r_p.hpp"

namespace trivium {

std::vector<std::string> formulation_names() {
  return {std::string(ROmega<double>::name), std::string(RP<double>::name),
          std::string(REpsilon<double>::name), std::string(REpsilonOmegaFirst<double>::name)};
}

RowAnalysis analyse_rows(const scenes::Scene& scene, double t) {
  return analyse_rows(tangent_system(make_mechanism<double>(scene), make_state<double>(scene, t)));
}

}  // namespace trivium
