#pragma once
/// The options of a program: their names, where their values go, and which values are accepted. CLI11 reads
/// the words and writes the help; program_options.cpp alone includes it, since it costs every unit that does
/// ten seconds.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/option_checks.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace trivium {

/// Where an option's value goes: a variable that outlives the reading of the command line.
using OptionTarget = std::variant<std::string*, int*, std::uint64_t*, double*, std::optional<int>*,
                                  std::optional<std::uint64_t>*, std::optional<double>*,
                                  std::vector<std::string>*, std::vector<double>*>;

/// One option, while it is described; valid as long as its ProgramOptions.
class ProgramOption {
 public:
  ProgramOption& required();
  ProgramOption& check(const OptionCheck& check);
  ProgramOption& one_of(const std::vector<std::string>& accepted);
  /// Accepts a whole number from `least` to `most`.
  ProgramOption& between(int least, int most);
  /// Takes as many values as there are names, which the help text shows.
  ProgramOption& values(const std::vector<std::string>& names);
  /// Takes one value each time that it is given, which the help text names.
  ProgramOption& may_repeat(const std::string& name);
  /// The help text shows the value that the variable has now.
  ProgramOption& show_default();
  ProgramOption& needs(const ProgramOption& other);
  ProgramOption& excludes(const ProgramOption& other);
  /// The help text leaves it out.
  ProgramOption& hide();

 private:
  friend class ProgramOptions;
  explicit ProgramOption(CLI::Option* option) : option_(option) {}

  CLI::Option* option_;
};

/// The command line of a program or of one of its subcommands. Copies describe the same command line.
class ProgramOptions {
 public:
  /// --help and --version are there from the start.
  ProgramOptions(const std::string& about, const std::string& program);

  /// A name that begins with a dash is an option, any other a positional argument.
  ProgramOption add_option(const std::string& name, OptionTarget target, const std::string& about = {});
  ProgramOption add_flag(const std::string& name, bool* target, const std::string& about = {});
  /// Exactly one of the subcommands must be named.
  ProgramOptions add_subcommand(const std::string& name, const std::string& about);
  /// What the help text says of --help, here and in subcommands added later.
  void describe_help(const std::string& about);

  /// As it was added.
  const std::string& name() const;
  /// Of a subcommand: the command line names it.
  bool is_chosen() const;

  /// Reads the command line, then runs the program and gives its exit code (run_guarded). What cannot be read
  /// is a message on stderr and exit_input_error; --help and --version print and end.
  int run(int argc, char** argv, const std::function<int()>& program);

 private:
  explicit ProgramOptions(std::shared_ptr<CLI::App> app) : app_(std::move(app)) {}

  std::shared_ptr<CLI::App> app_;
};

}  // namespace trivium
