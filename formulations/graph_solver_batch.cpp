#include "bodies/batch.hpp"
#include "formulations/graph_solver_impl.hpp"

template class trivium::GraphSolver<trivium::Batch<double, 4>>;
