#pragma once
/// The complete definition of GraphSolver, for instances in a Scalar for which the library has none. It
/// includes the elimination of links and closings, the refinement, and the restoring of independent rows.

#include "formulations/structured/closing_elimination_impl.hpp"
#include "formulations/structured/correction_impl.hpp"
#include "formulations/structured/dependent_rows_impl.hpp"
#include "formulations/structured/elimination_impl.hpp"
