/// Compiles the factorisation along the graph in Quad.

#include "bodies/numbers/quad.hpp"
#include "formulations/structured/correction_impl.hpp"
#include "formulations/structured/elimination_impl.hpp"

template class trivium::GraphSolver<trivium::Quad>;
