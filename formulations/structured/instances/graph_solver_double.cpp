#include "formulations/structured/graph_solver_impl.hpp"

template class trivium::GraphSolver<double>;
