#pragma once
/// Decides which regenerated results may be accepted, and takes them into the folder of accepted ones. The
/// program is accept_results.cpp.

#include <filesystem>
#include <string>
#include <vector>

#include "results/tools/results_schema.hpp"

namespace trivium {

/// Why a regenerated file may not be accepted: it is not what its schema says, or it was made by sources that
/// no commit holds, so that nobody could make it again. Empty if it may.
std::vector<std::string> refusals_of(const std::vector<ResultsSchema>& all, const std::filesystem::path& csv);

/// Copies the CSV and its manifest into the folder.
void accept(const std::filesystem::path& csv, const std::filesystem::path& directory);

}  // namespace trivium
