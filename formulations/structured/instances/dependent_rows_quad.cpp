#include "bodies/numbers/quad.hpp"
#include "formulations/structured/dependent_rows_impl.hpp"

template class trivium::GraphSolver<trivium::Quad>;
