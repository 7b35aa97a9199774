#pragma once
/// Plots the time per body against n as SVG files with gnuplot. An engine with linear cost is a horizontal
/// line.

#include <filesystem>
#include <vector>

#include "validation/cost/measurement.hpp"

namespace trivium::cost {

/// Writes FOLDER/chain.svg and FOLDER/ladder.svg, if these families were measured with several sizes. Throws
/// std::runtime_error if gnuplot fails.
void write_plots(const std::vector<Measurement>& rows, const std::filesystem::path& folder);

}  // namespace trivium::cost
