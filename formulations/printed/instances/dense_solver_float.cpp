/// Compiles the dense solver in float.

#include "formulations/printed/dense_solver_impl.hpp"

namespace trivium {
template class DenseSolver<float>;
}  // namespace trivium
