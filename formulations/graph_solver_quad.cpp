#include "formulations/graph_solver.hpp"

template class trivium::GraphSolver<trivium::Quad>;
