#include "formulations/r_p.hpp"
#include "validation/simulation_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<RP<Quad>>(const scenes::Scene&, const SimulationOptions&,
                                                SimulationObserver&);

}  // namespace trivium
