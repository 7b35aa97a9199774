#include "bodies/numbers/quad.hpp"
#include "formulations/structured/acceleration_solver_impl.hpp"

template class trivium::GraphAssembly<trivium::REpsilon<trivium::Quad>>;
template class trivium::AccelerationSolver<trivium::REpsilon<trivium::Quad>>;
