/// Compiles the implicit methods in Quad.

#include "integrators/implicit/methods_impl.hpp"
#include "integrators/quad.hpp"

namespace trivium::integrators {
template std::vector<MethodEntry<Quad>> implicit_methods<Quad>();
}  // namespace trivium::integrators
