#include "bodies/numbers/batch.hpp"
#include "formulations/structured/graph_solver_impl.hpp"

template class trivium::GraphSolver<trivium::Batch<double, 4>>;
