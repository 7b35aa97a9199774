#include "validation/cost/trivium_engines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "formulations/r_epsilon.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "validation/cost/trivium_engine.hpp"

namespace trivium::cost {

void throw_not_timed(const std::string& formulation) {
  throw ModelError(fmt::format("formulation \"{}\" is not timed; accepted: {}", formulation,
                               fmt::join(formulations, ", ")));
}

std::unique_ptr<Engine> trivium_engine(const scenes::Scene& scene, const std::string& formulation,
                                       Refined refined) {
  if (formulation == RP<double>::name) return std::make_unique<TriviumEngine<RP<double>>>(scene, refined);
  if (formulation == REpsilon<double>::name)
    return std::make_unique<TriviumEngine<REpsilon<double>>>(scene, refined);
  if (formulation == ROmega<double>::name)
    return std::make_unique<TriviumEngine<ROmega<double>>>(scene, refined);
  throw_not_timed(formulation);
}

std::vector<bool> unique_multipliers(const scenes::Scene& scene) {
  TriviumEngine<ROmega<double>> engine(scene, Refined::no);
  engine.evaluate();
  return engine.unique();
}

}  // namespace trivium::cost
