#pragma once
/// Choices by name, as the front door and the program take them: a formulation, a sequence of Euler angles. A
/// name that there is not is an Error of kind input that says which there are.

#include <string>
#include <string_view>
#include <vector>

#include "formulations/contract/chart_options.hpp"

namespace trivium {

/// Throws the error: what a name is of, the name, and those that there are.
[[noreturn]] void refuse_name(std::string_view noun, std::string_view name,
                              const std::vector<std::string>& accepted);

ChartOptions chart_options(const std::string& sequence, bool reframe);
void require_formulation(const std::string& name);

}  // namespace trivium
