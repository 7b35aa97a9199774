#include "validation/cost/trivium_engines.hpp"

#include "formulations/r_epsilon.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "validation/cost/trivium_engine.hpp"

namespace trivium::cost {

std::unique_ptr<Engine> our_engine(const scenes::Scene& scene, const std::string& formulation,
                                   Refined refined) {
  if (formulation == RP<double>::name) return std::make_unique<OurEngine<RP<double>>>(scene, refined);
  if (formulation == REpsilon<double>::name)
    return std::make_unique<OurEngine<REpsilon<double>>>(scene, refined);
  return std::make_unique<OurEngine<ROmega<double>>>(scene, refined);
}

std::vector<bool> unique_multipliers(const scenes::Scene& scene) {
  OurEngine<ROmega<double>> engine(scene, Refined::no);
  engine.evaluate();
  return engine.unique();
}

}  // namespace trivium::cost
