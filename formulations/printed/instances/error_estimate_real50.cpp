#include "bodies/numbers/real50.hpp"
#include "formulations/printed/instances/error_estimate.hpp"

TRIVIUM_ERROR_ESTIMATE(Real50)
