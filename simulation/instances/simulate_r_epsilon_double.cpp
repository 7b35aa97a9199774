#include "formulations/r_epsilon.hpp"
#include "simulation/simulate_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<REpsilon<double>>(const Model<double>&, const SimulationOptions&,
                                                        SimulationObserver&);

}  // namespace trivium
