#pragma once
/// Draws CPU time against error, one curve for each method. Failed runs are marked as well.

#include <filesystem>

#include "validation/precision/cost_at_error.hpp"

namespace trivium::precision {

/// Draws FOLDER/SCENE.svg and FOLDER/SCENE.pdf with gnuplot: Trivium's methods in r-omega and Simbody's
/// methods. A failed run has no error; its cross is therefore at the lower edge, above its tolerance on the
/// axis of errors. A failed run with a given step size has no tolerance; its cross is at the right margin.
/// The legend counts the failed runs of each method.
void plot(const SceneResult& result, const std::filesystem::path& folder);

}  // namespace trivium::precision
