#include "integrators/symplectic/methods.hpp"

#include "integrators/quad.hpp"
#include "integrators/symplectic/rattle.hpp"

namespace trivium::integrators {

template <class S>
std::unique_ptr<AnyMethod<S>> make_symplectic(std::string_view name) {
  if (name == "rattle") return adapt<S>(Rattle<AnySystem<S>>(2));
  if (name == "rattle4") return adapt<S>(Rattle<AnySystem<S>>(4));
  return nullptr;
}

template std::unique_ptr<AnyMethod<double>> make_symplectic<double>(std::string_view);
template std::unique_ptr<AnyMethod<Quad>> make_symplectic<Quad>(std::string_view);

}  // namespace trivium::integrators
