#include "formulations/formulation_list.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace trivium {

std::vector<std::string> formulation_names() { return AllFormulations::names(); }

void detail::throw_no_formulation(const std::string& name, const std::vector<std::string>& names) {
  throw ModelError(fmt::format("there is no formulation \"{}\"; accepted: {}", name, fmt::join(names, ", ")));
}

}  // namespace trivium
