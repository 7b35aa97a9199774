#include "bodies/numbers/quad.hpp"
#include "formulations/structured/acceleration_solver_impl.hpp"

template class trivium::GraphAssembly<trivium::REpsilonOmegaFirst<trivium::Quad>>;
template class trivium::AccelerationSolver<trivium::REpsilonOmegaFirst<trivium::Quad>>;
