/// Compiles the equations of motion of all formulations in Real100.

#include "formulations/instances/equations_of_motion.hpp"

#include "bodies/numbers/real50.hpp"

TRIVIUM_EQUATIONS_OF_MOTION(Real100)
