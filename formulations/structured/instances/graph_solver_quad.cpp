#include "formulations/structured/graph_solver_impl.hpp"

#include "bodies/numbers/quad.hpp"

template class trivium::GraphSolver<trivium::Quad>;
