#pragma once
/// The common part of the validation programs: command line, loading of scenes, writing of results, exit
/// code. Each program then contains only its question.

#include <functional>
#include <string>
#include <vector>

#include "base/command_line.hpp"
#include "base/program_options.hpp"
#include "results/tools/results_writer.hpp"
#include "validation/harness/consistent_scenes.hpp"

namespace trivium {

/// A validation program with the options SCENE... (unless its scenes are fixed), --json, --csv and --version,
/// and further ones added to `options()`.
class Program {
 public:
  /// `default_scenes` describes, for --help, the scenes that are used if the command line names none. Empty:
  /// the scenes are fixed.
  Program(const std::string& question, const std::string& name,
          const std::string& default_scenes = "the whole catalogue");

  ProgramOptions& options() { return options_; }
  int run(int argc, char** argv, const std::function<int()>& answer);

  bool names_scenes() const { return !names_.empty(); }
  const std::vector<std::string>& names() const { return names_; }
  bool json() const { return json_; }

  /// The named scenes, or else those of the catalogue, loaded by load_consistent_scenes.
  std::vector<NamedScene> scenes(double t) const;

  /// Writes the CSV and its manifest if --csv is given.
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
