#pragma once
/// The command line options of a program: names, target variables and accepted values. CLI11 parses the words
/// and writes the help text. Only program_options.cpp includes CLI11, because its headers add about ten
/// seconds of compile time to each translation unit.

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

/// The variable that receives an option's value. It must exist until the command line has been parsed.
using OptionTarget = std::variant<std::string*, int*, std::uint64_t*, double*, std::optional<int>*,
                                  std::optional<std::uint64_t>*, std::optional<double>*,
                                  std::vector<std::string>*, std::vector<double>*>;

/// Handle for describing one option. Valid as long as its ProgramOptions exists.
class ProgramOption {
 public:
  ProgramOption& required();
  ProgramOption& check(const OptionCheck& check);
  ProgramOption& one_of(const std::vector<std::string>& accepted);
  /// Accepts a whole number from `least` to `most`.
  ProgramOption& between(int least, int most);
  /// Takes one value per name; the help text shows the names.
  ProgramOption& values(const std::vector<std::string>& names);
  /// The option may be given several times, with one value each time; the help text calls the value `name`.
  ProgramOption& may_repeat(const std::string& name);
  /// Shows the present value of the target variable as default in the help text.
  ProgramOption& show_default();
  ProgramOption& needs(const ProgramOption& other);
  ProgramOption& excludes(const ProgramOption& other);
  /// Omits the option from the help text.
  ProgramOption& hide();

 private:
  friend class ProgramOptions;
  explicit ProgramOption(CLI::Option* option) : option_(option) {}

  CLI::Option* option_;
};

/// The command line of a program or of one of its subcommands. Copies describe the same command line.
class ProgramOptions {
 public:
  /// Adds --help and --version.
  ProgramOptions(const std::string& about, const std::string& program);

  /// A name that begins with a dash makes an option, any other name a positional argument.
  ProgramOption add_option(const std::string& name, OptionTarget target, const std::string& about = {});
  ProgramOption add_flag(const std::string& name, bool* target, const std::string& about = {});
  /// From now on the command line must name exactly one of the subcommands.
  ProgramOptions add_subcommand(const std::string& name, const std::string& about);
  /// Sets the description of --help in the help text, also for subcommands added later.
  void describe_help(const std::string& about);

  /// Name of the program or subcommand.
  const std::string& name() const;
  /// Whether the parsed command line names this subcommand.
  bool is_chosen() const;

  /// Parses the command line, runs `program` by run_guarded and returns its exit code. An invalid command
  /// line gives a message on stderr and exit_input_error; --help and --version print and return exit_done.
  int run(int argc, char** argv, const std::function<int()>& program);

 private:
  explicit ProgramOptions(std::shared_ptr<CLI::App> app) : app_(std::move(app)) {}

  std::shared_ptr<CLI::App> app_;
};

}  // namespace trivium
