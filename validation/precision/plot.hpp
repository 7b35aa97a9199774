#pragma once
/// CPU time over errors as figures, a line a method. Runs that failed are marked, not dropped.

#include <filesystem>

#include "validation/precision/cost_at_error.hpp"

namespace trivium::precision {

/// Draws FOLDER/SCENE.svg and FOLDER/SCENE.pdf, by gnuplot: ours in r-omega and Simbody's. Runs that failed
/// are crosses at the bottom, at the tolerance or, of given steps, at the right; the legend counts them.
void plot(const SceneResult& result, const std::filesystem::path& folder);

}  // namespace trivium::precision
