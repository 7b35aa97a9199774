/// Compiles the dense solver in long double.

#include "formulations/printed/dense_solver_impl.hpp"

namespace trivium {
template class DenseSolver<long double>;
}  // namespace trivium
