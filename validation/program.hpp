#pragma once
/// What the validation executables have in common: their command line, the scenes that it names, and how they
/// end.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "validation/catalogue.hpp"
#include "validation/results_file.hpp"

namespace trivium {

/// Parses the command line, then runs what it asks for; see run_guarded.
int parse_and_run(CLI::App& app, int argc, char** argv, const std::function<int()>& program);

/// What a solver or a criterion made of a batch; a solver that failed counts more.
ExitCode batch_exit(bool all_solved, bool all_passed);

/// A solver's message, with the scene's source in front unless it begins with it.
std::string name_source(const std::string& source, std::string_view message);

/// The lines below a table that say what could not be solved; neighbours that say the same share one.
class ErrorLines {
 public:
  /// `about`: the part of the scene's work that failed; empty for all of it.
  void add(const std::string& message, std::string_view about = {});
  std::string text() const;

 private:
  struct Line {
    std::string message, about;
  };
  std::vector<Line> lines_;
};

/// One validation: SCENE..., --json, --csv and --version, and what the program adds to `options`.
class Program {
 public:
  /// `default_scenes`: what is taken where no scene is named, in words.
  Program(const std::string& question, const std::string& name,
          const std::string& default_scenes = "the whole catalogue");

  CLI::App& options() { return app_; }
  int run(int argc, char** argv, const std::function<int()>& answer);

  bool names_scenes() const { return !names_.empty(); }
  const std::vector<std::string>& names() const { return names_; }
  bool json() const { return json_; }

  /// The scenes named, else the catalogue's, as load_consistent_scenes gives them.
  std::vector<NamedScene> scenes(double t) const;

  /// Writes the CSV and its manifest, if --csv asks for them.
  void write(const ResultsFile& results) const;

 private:
  CLI::App app_;
  std::vector<std::string> names_;
  bool json_ = false;
  std::string csv_;
  int argc_ = 0;
  char** argv_ = nullptr;
};

}  // namespace trivium
