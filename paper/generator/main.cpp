/// paper_tables: writes paper/tables from results/, or checks that the existing files are equal to the
/// generated files.

#include <fmt/format.h>

#include <cstdio>

#include "base/exit_code.hpp"
#include "base/program_options.hpp"
#include "base/whole_file.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

int write(const Files& files, const fs::path& directory) {
  fs::create_directories(directory);
  for (const auto& [name, text] : files) write_whole(directory / name, text);
  return exit_done;
}

/// The number of the first line that differs.
std::size_t differing_line(const std::string& a, const std::string& b) {
  const auto at = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
  return 1 + static_cast<std::size_t>(std::count(a.begin(), at, '\n'));
}

int check(const Files& files, const fs::path& directory) {
  std::vector<std::string> stale;
  for (const auto& [name, text] : files) {
    if (!fs::exists(directory / name)) {
      stale.push_back(name + ": missing");
      continue;
    }
    const std::string present = read_whole(directory / name);
    if (present != text)
      stale.push_back(fmt::format("{}: line {} differs from the table made from results/", name,
                                  differing_line(present, text)));
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(directory))
    if (const std::string name = entry.path().filename().string(); !files.contains(name))
      stale.push_back(name + ": is not a generated file");
  for (const std::string& line : stale) fmt::print("{}\n", line);
  if (stale.empty()) fmt::print("{} files in {} are current\n", files.size(), directory.filename().string());
  return stale.empty() ? exit_done : exit_criterion_failed;
}

}  // namespace

}  // namespace trivium::paper

int main(int argc, char** argv) {
  using namespace trivium;
  ProgramOptions options("Writes the tables of the paper from accepted results", "paper_tables");
  std::string results, tables;
  bool only_check = false;
  options.add_option("RESULTS", &results, "Folder of the accepted results, with their schema").required();
  options.add_option("TABLES", &tables, "Folder of the tables").required();
  options.add_flag("--check", &only_check,
                   "Write nothing; exit code 1 if TABLES differs from the tables made from RESULTS");
  return options.run(argc, argv, [&] {
    const auto files = paper::render(results);
    return only_check ? paper::check(files, tables) : paper::write(files, tables);
  });
}
