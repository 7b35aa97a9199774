/// Copies regenerated results into results/. Acceptance is a deliberate step, because all numbers in the
/// paper come from these files.

#include <fmt/format.h>

#include <cstdio>

#include "base/exit_code.hpp"
#include "base/program_options.hpp"
#include "results/tools/results_acceptance.hpp"
#include "results/tools/results_table.hpp"

namespace trivium {

namespace {

int run(const std::vector<std::string>& files, const std::string& directory) {
  const auto schema = read_schema(std::filesystem::path(directory) / "schema.json");
  std::vector<std::string> refusals;
  for (const std::string& file : files)
    for (std::string& why : refusals_of(schema, file)) refusals.push_back(std::move(why));
  for (const std::string& why : refusals) fmt::print(stderr, "not accepted: {}\n", why);
  if (!refusals.empty()) return exit_criterion_failed;
  for (const std::string& file : files) {
    accept(file, directory);
    fmt::print("accepted {}\n", std::filesystem::path(file).filename().string());
  }
  return exit_done;
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  ProgramOptions options("Copies regenerated results, all or none, into the folder of accepted results",
                         "accept_results");
  std::vector<std::string> files;
  std::string directory;
  options.add_option("REGENERATED", &files, "CSV files, with their manifests next to them").required();
  options.add_option("--into", &directory, "Folder of the accepted results, with their schema").required();
  return options.run(argc, argv, [&] { return run(files, directory); });
}
