/// Compiles the error estimates of all formulations in double.

#include "bodies/numbers/scalar.hpp"
#include "formulations/printed/instances/error_estimate.hpp"

TRIVIUM_ERROR_ESTIMATE(double)
