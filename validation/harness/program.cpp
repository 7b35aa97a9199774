/// The options that validation programs share: scenes, --json and --csv.

#include "validation/harness/program.hpp"

#include <fmt/format.h>

#include "base/option_checks.hpp"
#include "results/tools/results_table.hpp"

namespace trivium {

Program::Program(const std::string& question, const std::string& name, const std::string& default_scenes)
    : options_(question, name) {
  if (!default_scenes.empty())
    options_.add_option("SCENE", &names_,
                        fmt::format("Scene files or catalogue names (default: {})", default_scenes));
  options_.add_flag("--json", &json_, "JSON on stdout");
  options_.add_option("--csv", &csv_, "Write the table to this CSV file, and a manifest next to it")
      .check(writable_file())
      .check({[](const std::string& csv) { return why_not_writable(manifest_of(csv).string()); }, ""});
}

int Program::run(int argc, char** argv, const std::function<int()>& answer) {
  argc_ = argc;
  argv_ = argv;
  return options_.run(argc, argv, answer);
}

std::vector<NamedScene> Program::scenes(double t) const {
  std::vector<std::string> names = names_;
  if (names.empty())
    for (const auto& file : catalogue()) names.push_back(file.string());
  return load_consistent_scenes(names, t);
}

void Program::write(const ResultsFile& results) const {
  if (!csv_.empty()) results.write(csv_, argc_, argv_);
}

}  // namespace trivium
