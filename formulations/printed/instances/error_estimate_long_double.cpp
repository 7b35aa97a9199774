/// Compiles the error estimates of all formulations in long double.

#include "bodies/numbers/quad.hpp"
#include "formulations/printed/instances/error_estimate.hpp"

TRIVIUM_ERROR_ESTIMATE(long double)
