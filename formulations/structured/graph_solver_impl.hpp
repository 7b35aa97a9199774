#pragma once
/// The one definition behind the GraphSolver instances, for those of a Scalar that has none. It gathers the
/// elimination, the closings, the corrections and the dependent rows.

#include "formulations/structured/closing_elimination_impl.hpp"
#include "formulations/structured/correction_impl.hpp"
#include "formulations/structured/dependent_rows_impl.hpp"
#include "formulations/structured/elimination_impl.hpp"
