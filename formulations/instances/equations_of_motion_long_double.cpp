/// Compiles the equations of motion of all formulations in long double.

#include "formulations/instances/equations_of_motion.hpp"

TRIVIUM_EQUATIONS_OF_MOTION(long double)
