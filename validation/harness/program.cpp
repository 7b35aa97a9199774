#include "validation/harness/program.hpp"

#include <fmt/format.h>

#include "base/option_checks.hpp"
#include "base/standard_output.hpp"
#include "results/tools/results_table.hpp"

namespace trivium {

Program::Program(const std::string& question, const std::string& name, const std::string& default_scenes)
    : app_(question, name) {
  app_.set_version_flag("--version", "trivium " TRIVIUM_VERSION);
  app_.add_option("SCENE", names_,
                  fmt::format("Scene files or catalogue names (default: {})", default_scenes));
  app_.add_flag("--json", json_, "JSON on stdout");
  app_.add_option("--csv", csv_, "Write the table to this CSV file, and a manifest beside it")
      ->check(writable_file())
      ->check([](const std::string& csv) { return why_not_writable(manifest_of(csv).string()); });
}

int Program::run(int argc, char** argv, const std::function<int()>& answer) {
  argc_ = argc;
  argv_ = argv;
  try {
    app_.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return run_and_flush([&]() -> int { return app_.exit(error) == 0 ? exit_done : exit_input_error; });
  }
  return run_guarded(answer);
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
