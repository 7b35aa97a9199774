#include "bodies/numbers/quad.hpp"
#include "formulations/r_omega.hpp"
#include "simulation/simulate_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<ROmega<Quad>>(const Model<Quad>&, const SimulationOptions&,
                                                    SimulationObserver&);

}  // namespace trivium
