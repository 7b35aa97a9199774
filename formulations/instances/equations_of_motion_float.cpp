#include "formulations/instances/equations_of_motion.hpp"

TRIVIUM_EQUATIONS_OF_MOTION(float)
