#include "formulations/structured/acceleration_solver_impl.hpp"

template class trivium::GraphAssembly<trivium::REpsilon<double>>;
template class trivium::AccelerationSolver<trivium::REpsilon<double>>;
