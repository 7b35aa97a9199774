#pragma once
/// Draws CPU time against error, one curve for each method. Failed runs are marked, not omitted.

#include <filesystem>

#include "validation/precision/cost_at_error.hpp"

namespace trivium::precision {

/// Draws FOLDER/SCENE.svg and FOLDER/SCENE.pdf with gnuplot: Trivium's methods in r-omega and Simbody's
/// methods. Failed runs are crosses at the bottom, at their tolerance, or at the right margin for given
/// steps; the legend counts them.
void plot(const SceneResult& result, const std::filesystem::path& folder);

}  // namespace trivium::precision
