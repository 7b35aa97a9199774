#pragma once
/// Decides which regenerated results may be accepted, and copies them into the folder of accepted results.
/// The program is accept_results.cpp.

#include <filesystem>
#include <string>
#include <vector>

#include "results/tools/results_schema.hpp"

namespace trivium {

/// The reasons why a regenerated file must not be accepted; empty if it may be. A reason is a violation of
/// the schema, or a build from sources that are not committed, so that nobody could make the file again.
std::vector<std::string> refusals_of(const std::vector<ResultsSchema>& all, const std::filesystem::path& csv);

/// Copies the CSV and its manifest into the folder.
void accept(const std::filesystem::path& csv, const std::filesystem::path& directory);

}  // namespace trivium
