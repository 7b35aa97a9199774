#include "bodies/numbers/quad.hpp"
#include "formulations/structured/acceleration_solver_impl.hpp"

template class trivium::GraphAssembly<trivium::ROmega<trivium::Quad>>;
template class trivium::AccelerationSolver<trivium::ROmega<trivium::Quad>>;
