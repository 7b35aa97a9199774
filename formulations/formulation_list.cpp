#include "formulations/formulation_list.hpp"

#include "base/error.hpp"

namespace trivium {

std::vector<std::string> formulation_names() {
  return std::apply([](auto... f) { return std::vector<std::string>{std::string(decltype(f)::name)...}; },
                    FormulationList<double>{});
}

void detail::throw_no_formulation(const std::string& name) {
  throw ModelError(fmt::format("there is no formulation \"{}\"; accepted: {}", name,
                               fmt::join(formulation_names(), ", ")));
}

}  // namespace trivium
