#include "formulations/structured/acceleration_solver_impl.hpp"

template class trivium::GraphAssembly<trivium::ROmega<double>>;
template class trivium::AccelerationSolver<trivium::ROmega<double>>;
