#include "formulations/r_epsilon_omega_first.hpp"
#include "validation/simulation_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<REpsilonOmegaFirst<double>>(const scenes::Scene&,
                                                                  const SimulationOptions&,
                                                                  SimulationObserver&);

}  // namespace trivium
