/// Compiles the implicit methods in double.

#include "integrators/implicit/methods_impl.hpp"

namespace trivium::integrators {
template std::vector<MethodEntry<double>> implicit_methods<double>();
}  // namespace trivium::integrators
