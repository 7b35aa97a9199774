/// Compiles the structured solver in four lanes of double.

#include "bodies/numbers/batch.hpp"
#include "formulations/equations_of_motion_impl.hpp"
#include "formulations/structured/acceleration_solver_impl.hpp"

// instances for the tests only
template class trivium::GraphAssembly<trivium::ROmega<trivium::Batch<double, 4>>>;
template class trivium::GraphAssembly<trivium::RP<trivium::Batch<double, 4>>>;
template class trivium::GraphAssembly<trivium::REpsilon<trivium::Batch<double, 4>>>;
template class trivium::AccelerationSolver<trivium::ROmega<trivium::Batch<double, 4>>>;
template class trivium::AccelerationSolver<trivium::RP<trivium::Batch<double, 4>>>;
template class trivium::AccelerationSolver<trivium::REpsilon<trivium::Batch<double, 4>>>;
