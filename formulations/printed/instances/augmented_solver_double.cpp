#include "formulations/printed/instances/augmented_solver.hpp"

TRIVIUM_AUGMENTED_SOLVER(double)
