#include "formulations/structured/acceleration_solver_impl.hpp"

template class trivium::GraphAssembly<trivium::REpsilonOmegaFirst<double>>;
template class trivium::AccelerationSolver<trivium::REpsilonOmegaFirst<double>>;
