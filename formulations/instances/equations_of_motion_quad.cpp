/// Compiles the equations of motion of all formulations in Quad.

#include "formulations/instances/equations_of_motion.hpp"

#include "bodies/numbers/quad.hpp"

TRIVIUM_EQUATIONS_OF_MOTION(Quad)
