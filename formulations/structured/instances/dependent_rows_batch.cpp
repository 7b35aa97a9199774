/// Compiles the treatment of dependent rows in four lanes of double.

#include "bodies/numbers/batch.hpp"
#include "formulations/structured/closing_elimination_impl.hpp"
#include "formulations/structured/dependent_rows_impl.hpp"

template class trivium::GraphSolver<trivium::Batch<double, 4>>;
