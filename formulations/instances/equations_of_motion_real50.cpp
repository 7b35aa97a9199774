#include "formulations/instances/equations_of_motion.hpp"

#include "bodies/numbers/real50.hpp"

TRIVIUM_EQUATIONS_OF_MOTION(Real50)
