/// Compiles the dense solver in Quad.

#include "formulations/printed/dense_solver_impl.hpp"

#include "bodies/numbers/quad.hpp"

namespace trivium {
template class DenseSolver<Quad>;
}  // namespace trivium
