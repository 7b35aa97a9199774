/// Compiles the treatment of dependent rows in Quad.

#include "bodies/numbers/quad.hpp"
#include "formulations/structured/closing_elimination_impl.hpp"
#include "formulations/structured/dependent_rows_impl.hpp"

template class trivium::GraphSolver<trivium::Quad>;
