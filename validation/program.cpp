#include "validation/program.hpp"

#include <fmt/format.h>

#include "results/results_table.hpp"
#include "results/standard_output.hpp"
#include "validation/option_checks.hpp"

namespace trivium {

int parse_and_run(CLI::App& app, int argc, char** argv, const std::function<int()>& program) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return run_and_flush([&]() -> int { return app.exit(error) == 0 ? exit_done : exit_input_error; });
  }
  return run_guarded(program);
}

ExitCode batch_exit(bool all_solved, bool all_passed) {
  return !all_solved ? exit_solver_failed : all_passed ? exit_done : exit_criterion_failed;
}

std::string name_source(const std::string& source, std::string_view message) {
  const bool named = message.starts_with(source + " ") || message.starts_with(source + ":");
  return named ? std::string(message) : fmt::format("{}: {}", source, message);
}

void ErrorLines::add(const std::string& message, std::string_view about) {
  if (lines_.empty() || lines_.back().message != message)
    lines_.push_back({message, std::string(about)});
  else if (!about.empty())
    lines_.back().about += fmt::format(", {}", about);
}

std::string ErrorLines::text() const {
  std::string out;
  for (const auto& [message, about] : lines_)
    out += fmt::format("error: {}{}\n", message, about.empty() ? "" : fmt::format(" ({})", about));
  return out;
}

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
  return parse_and_run(app_, argc, argv, answer);
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
