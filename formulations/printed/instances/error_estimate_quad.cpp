/// Compiles the error estimates of all formulations in Quad.

#include "bodies/numbers/real50.hpp"
#include "formulations/printed/instances/error_estimate.hpp"

TRIVIUM_ERROR_ESTIMATE(Quad)
