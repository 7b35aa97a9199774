#include "validation/cost/ours.hpp"
#include "formulations/r_epsilon.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "validation/cost/our_engine.hpp"

namespace trivium::cost {

std::unique_ptr<Engine> our_engine(const scenes::Scene& scene, const std::string& formulation,
                                   Refined refined) {
  const Refinement refinement = refined == Refined::yes ? Refinement::once : Refinement::none;
  if (formulation == RP<double>::name) return std::make_unique<OurEngine<RP<double>>>(scene, refinement);
  if (formulation == REpsilon<double>::name)
    return std::make_unique<OurEngine<REpsilon<double>>>(scene, refinement);
  return std::make_unique<OurEngine<ROmega<double>>>(scene, refinement);
}

std::vector<bool> unique_multipliers(const scenes::Scene& scene) {
  OurEngine<ROmega<double>> engine(scene, Refinement::none);
  engine.evaluate();
  return engine.unique();
}

}  // namespace trivium::cost
