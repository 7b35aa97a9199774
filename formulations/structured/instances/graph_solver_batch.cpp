/// Compiles the factorisation along the graph in four lanes of double.

#include "bodies/numbers/batch.hpp"
#include "formulations/structured/correction_impl.hpp"
#include "formulations/structured/elimination_impl.hpp"

template class trivium::GraphSolver<trivium::Batch<double, 4>>;
