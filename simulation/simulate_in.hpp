#pragma once
/// A simulation in one formulation and Scalar, compiled once each (simulation/instances). Others call
/// simulate, which chooses the formulation by its name.

#include "formulations/formulation.hpp"
#include "mechanism/model.hpp"
#include "simulation/simulate.hpp"

namespace trivium {

template <Formulation F>
SimulationReport simulate_in(const ModelOf<F>& model, const SimulationOptions& options,
                             SimulationObserver& observer);

}  // namespace trivium
