#include "formulations/printed/dense_solver_impl.hpp"

namespace trivium {
template class DenseSolver<Real50>;
}  // namespace trivium
