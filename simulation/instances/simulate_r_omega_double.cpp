#include "formulations/r_omega.hpp"
#include "simulation/simulate_impl.hpp"

namespace trivium {

template SimulationReport simulate_in<ROmega<double>>(const Model<double>&, const SimulationOptions&,
                                                      SimulationObserver&);

}  // namespace trivium
