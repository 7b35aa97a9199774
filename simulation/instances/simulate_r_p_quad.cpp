#include "bodies/numbers/quad.hpp"
#include "formulations/r_p.hpp"
#include "simulation/simulate_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<RP<Quad>>(const Model<Quad>&, const SimulationOptions&,
                                                SimulationObserver&);

}  // namespace trivium
