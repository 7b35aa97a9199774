/// Compiles the factorisation along the graph in double.

#include "formulations/structured/correction_impl.hpp"
#include "formulations/structured/elimination_impl.hpp"

template class trivium::GraphSolver<double>;
