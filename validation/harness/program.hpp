#pragma once
/// What the validation executables have in common: their command line, the scenes that it names, and how they
/// end. Each executable is then its question alone.

#include <functional>
#include <string>
#include <vector>

#include "base/command_line.hpp"
#include "base/program_options.hpp"
#include "results/tools/results_writer.hpp"
#include "validation/harness/consistent_scenes.hpp"

namespace trivium {

/// One validation: SCENE..., --json, --csv and --version, and what the program adds to `options`.
class Program {
 public:
  /// `default_scenes`: what is taken where no scene is named, in words.
  Program(const std::string& question, const std::string& name,
          const std::string& default_scenes = "the whole catalogue");

  ProgramOptions& options() { return options_; }
  int run(int argc, char** argv, const std::function<int()>& answer);

  bool names_scenes() const { return !names_.empty(); }
  const std::vector<std::string>& names() const { return names_; }
  bool json() const { return json_; }

  /// The scenes named, else the catalogue's, as load_consistent_scenes gives them.
  std::vector<NamedScene> scenes(double t) const;

  /// Writes the CSV and its manifest, if --csv asks for them.
  void write(const ResultsFile& results) const;

 private:
  ProgramOptions options_;
  std::vector<std::string> names_;
  bool json_ = false;
  std::string csv_;
  int argc_ = 0;
  char** argv_ = nullptr;
};

}  // namespace trivium
