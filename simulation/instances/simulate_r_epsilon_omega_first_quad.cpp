#include "bodies/numbers/quad.hpp"
#include "formulations/r_epsilon_omega_first.hpp"
#include "simulation/simulate_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<REpsilonOmegaFirst<Quad>>(const Model<Quad>&, const SimulationOptions&,
                                                                SimulationObserver&);

}  // namespace trivium
