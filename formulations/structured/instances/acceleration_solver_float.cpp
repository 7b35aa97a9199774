/// Compiles the structured solver in float.

#include "formulations/structured/acceleration_solver_impl.hpp"

// instances for the tests only
template class trivium::GraphAssembly<trivium::ROmega<float>>;
template class trivium::GraphAssembly<trivium::RP<float>>;
template class trivium::GraphAssembly<trivium::REpsilon<float>>;
template class trivium::AccelerationSolver<trivium::ROmega<float>>;
template class trivium::AccelerationSolver<trivium::RP<float>>;
template class trivium::AccelerationSolver<trivium::REpsilon<float>>;
