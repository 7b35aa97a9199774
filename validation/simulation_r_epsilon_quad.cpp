#include "formulations/r_epsilon.hpp"
#include "validation/simulation_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<REpsilon<Quad>>(const scenes::Scene&, const SimulationOptions&,
                                                      SimulationObserver&);

}  // namespace trivium
