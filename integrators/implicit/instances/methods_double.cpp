#include "integrators/implicit/methods_impl.hpp"

namespace trivium::integrators {
template std::unique_ptr<AnyMethod<double>> make_implicit<double>(std::string_view,
                                                                  const std::optional<Tolerances>&,
                                                                  const MethodParameters&);
}  // namespace trivium::integrators
