#include "results/tools/results_acceptance.hpp"

#include <fmt/format.h>

#include "base/whole_file.hpp"
#include "results/tools/results_comparison.hpp"

namespace trivium {

namespace fs = std::filesystem;

std::vector<std::string> refusals_of(const std::vector<ResultsSchema>& all, const fs::path& csv) {
  const ResultsTable table = read_results(csv);
  std::vector<std::string> refusals;
  for (const Difference& d : check_results(find_schema(all, table.name), table))
    refusals.push_back(fmt::format("{}: {}{}{}: {} (rule: {})", table.name, d.row, d.row.empty() ? "" : ", ",
                                   d.column, d.accepted, d.rule));
  const std::string& commit = table.manifest.commit;
  if (commit == "unknown" || commit.ends_with("-dirty"))
    refusals.push_back(
        fmt::format("{}: made from uncommitted sources ({}); commit the sources first", table.name, commit));
  return refusals;
}

void accept(const fs::path& csv, const fs::path& directory) {
  for (const fs::path& file : {csv, manifest_of(csv)})
    write_whole(directory / file.filename(), read_whole(file));
}

}  // namespace trivium
