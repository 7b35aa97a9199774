/// Words the messages about unknown names, with the nearest accepted name as a proposal.

#include "trivium/choices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "formulations/formulation_list.hpp"
#include "scenes/format/scene_error.hpp"

namespace trivium {

void refuse_name(std::string_view noun, std::string_view name, const std::vector<std::string>& accepted) {
  const std::vector<std::string_view> known(accepted.begin(), accepted.end());
  const std::string slip = scenes::nearest(name, known);
  throw Error(ErrorKind::input,
              fmt::format("there is no {} {}; accepted: {}{}", noun, scenes::in_quotes(name),
                          known.empty() ? "none" : scenes::list_of(known),
                          slip.empty() ? "" : fmt::format(" (did you mean {}?)", scenes::in_quotes(slip))));
}

ChartOptions chart_options(const std::string& sequence, bool reframe) {
  if (const auto known = parse_euler_sequence(sequence)) return {*known, reframe};
  refuse_name("sequence of Euler angles", sequence,
              {euler_sequence_names.begin(), euler_sequence_names.end()});
}

void require_formulation(const std::string& name) {
  const std::vector<std::string> names = formulation_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) refuse_name("formulation", name, names);
}

}  // namespace trivium
