#include "formulations/structured/correction_impl.hpp"
#include "formulations/structured/elimination_impl.hpp"

#include "bodies/numbers/quad.hpp"

template class trivium::GraphSolver<trivium::Quad>;
