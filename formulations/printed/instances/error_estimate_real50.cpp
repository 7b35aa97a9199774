/// Compiles the error estimates of all formulations in Real50.

#include "bodies/numbers/real50.hpp"
#include "formulations/printed/instances/error_estimate.hpp"

TRIVIUM_ERROR_ESTIMATE(Real50)
