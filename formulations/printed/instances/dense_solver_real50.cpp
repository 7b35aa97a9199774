/// Compiles the dense solver in Real50.

#include "formulations/printed/dense_solver_impl.hpp"

#include "bodies/numbers/real50.hpp"

namespace trivium {
template class DenseSolver<Real50>;
}  // namespace trivium
