#pragma once
/// Checks of choices that a caller makes by name: a formulation, a sequence of Euler angles. An unknown name
/// is an Error of kind input whose message lists the accepted names.

#include <string>
#include <string_view>
#include <vector>

#include "formulations/contract/chart_options.hpp"

namespace trivium {

/// Throws an Error of kind input for an unknown name. `noun` says what is chosen by the name, such as
/// "formulation". The message proposes the nearest of the accepted names.
[[noreturn]] void refuse_name(std::string_view noun, std::string_view name,
                              const std::vector<std::string>& accepted);

/// The chart options of a sequence such as "313". Throws an Error of kind input if there is no such sequence.
ChartOptions chart_options(const std::string& sequence, bool reframe);
/// Throws an Error of kind input if there is no formulation of this name.
void require_formulation(const std::string& name);

}  // namespace trivium
