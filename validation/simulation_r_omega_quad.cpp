#include "formulations/r_omega.hpp"
#include "validation/simulation_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<ROmega<Quad>>(const scenes::Scene&, const SimulationOptions&,
                                                    SimulationObserver&);

}  // namespace trivium
