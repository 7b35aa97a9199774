/// Compiles the dense solver in double.

#include "formulations/printed/dense_solver_impl.hpp"

namespace trivium {
template class DenseSolver<double>;
}  // namespace trivium
