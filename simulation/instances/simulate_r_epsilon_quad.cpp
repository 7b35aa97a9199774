#include "bodies/numbers/quad.hpp"
#include "formulations/r_epsilon.hpp"
#include "simulation/simulate_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<REpsilon<Quad>>(const Model<Quad>&, const SimulationOptions&,
                                                      SimulationObserver&);

}  // namespace trivium
