#include "formulations/structured/dependent_rows_impl.hpp"

template class trivium::GraphSolver<double>;
