#pragma once
/// Whether an error message announces a failure: it says what failed, where, when, why, and what to try.

#include <optional>
#include <string>
#include <string_view>

#include "scenes/scene.hpp"

namespace trivium::hard {

/// What a message lacks of a place (the name of a part of the scene, in quotes), a time within the run, its
/// reason and advice; empty if nothing. `reason`: words that it has to contain; empty: any reason.
std::string missing_in_announcement(const std::string& message, std::optional<double> when,
                                    const scenes::Scene& scene, double start, double end,
                                    const std::string& reason = {});

/// The number after the last `phrase`; NaN if there is none.
double number_after(const std::string& text, std::string_view phrase);

}  // namespace trivium::hard
