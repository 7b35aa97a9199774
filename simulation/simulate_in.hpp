#pragma once
/// Simulation in one formulation and Scalar, each compiled once (simulation/instances). Callers normally use
/// simulate() of simulate.hpp, which chooses the formulation by its name.

#include "formulations/formulation.hpp"
#include "mechanism/model.hpp"
#include "simulation/simulate.hpp"

namespace trivium {

/// Simulates as simulate() does (simulation/simulate.hpp), in the formulation F. `options.formulation` is
/// ignored.
template <Formulation F>
SimulationReport simulate_in(const ModelOf<F>& model, const SimulationOptions& options,
                             SimulationObserver& observer);

}  // namespace trivium
