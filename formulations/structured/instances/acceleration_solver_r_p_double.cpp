#include "formulations/structured/acceleration_solver_impl.hpp"

template class trivium::GraphAssembly<trivium::RP<double>>;
template class trivium::AccelerationSolver<trivium::RP<double>>;
