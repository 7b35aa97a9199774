/// Compiles the equations of motion of all formulations in double.

#include "formulations/instances/equations_of_motion.hpp"

TRIVIUM_EQUATIONS_OF_MOTION(double)
