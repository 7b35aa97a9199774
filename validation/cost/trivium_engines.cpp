/// Turns the name of a formulation into its engine, in double.

#include "validation/cost/trivium_engines.hpp"

#include "formulations/formulation_list.hpp"
#include "validation/cost/trivium_engine.hpp"

namespace trivium::cost {

std::unique_ptr<Engine> trivium_engine(const scenes::Scene& scene, const std::string& formulation,
                                       Refined refined) {
  return with_formulation<double>(formulation, [&]<class F>() -> std::unique_ptr<Engine> {
    return std::make_unique<TriviumEngine<F>>(scene, refined);
  });
}

std::vector<bool> unique_multipliers(const scenes::Scene& scene) {
  TriviumEngine<ROmega<double>> engine(scene, Refined::no);
  engine.evaluate();
  return engine.unique();
}

}  // namespace trivium::cost
