#include "integrators/implicit/methods_impl.hpp"
#include "integrators/quad.hpp"

namespace trivium::integrators {
template std::unique_ptr<AnyMethod<Quad>> make_implicit<Quad>(std::string_view,
                                                              const std::optional<Tolerances>&,
                                                              const MethodParameters&);
}  // namespace trivium::integrators
