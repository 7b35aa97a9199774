#pragma once
/// Time per body against n, as SVG, by gnuplot. An engine of linear cost is a level line there.

#include <filesystem>
#include <vector>

#include "validation/cost/measurement.hpp"

namespace trivium::cost {

/// FOLDER/chain.svg and FOLDER/ladder.svg, of those families that have several sizes. Throws
/// std::runtime_error where gnuplot fails.
void write_plots(const std::vector<Measurement>& rows, const std::filesystem::path& folder);

}  // namespace trivium::cost
