#include "base/program_options.hpp"

#include <CLI/CLI.hpp>

#include "base/command_line.hpp"
#include "base/standard_output.hpp"

namespace trivium {

ProgramOption& ProgramOption::required() {
  option_->required();
  return *this;
}

ProgramOption& ProgramOption::check(const OptionCheck& check) {
  option_->check(
      CLI::Validator([error_of = check.error_of](std::string& text) { return error_of(text); }, check.name));
  return *this;
}

ProgramOption& ProgramOption::one_of(const std::vector<std::string>& accepted) {
  option_->check(CLI::IsMember(accepted));
  return *this;
}

ProgramOption& ProgramOption::between(int least, int most) {
  option_->check(CLI::Range(least, most));
  return *this;
}

ProgramOption& ProgramOption::values(const std::vector<std::string>& names) {
  option_->expected(static_cast<int>(names.size()))->type_name(CLI::detail::join(names, " "));
  return *this;
}

ProgramOption& ProgramOption::may_repeat(const std::string& name) {
  option_->allow_extra_args(false)->type_name(name);
  return *this;
}

ProgramOption& ProgramOption::show_default() {
  option_->capture_default_str();
  return *this;
}

ProgramOption& ProgramOption::needs(const ProgramOption& other) {
  option_->needs(other.option_);
  return *this;
}

ProgramOption& ProgramOption::excludes(const ProgramOption& other) {
  option_->excludes(other.option_);
  return *this;
}

ProgramOption& ProgramOption::hide() {
  option_->group("");
  return *this;
}

namespace {

void add_version(CLI::App& app) { app.set_version_flag("--version", "trivium " TRIVIUM_VERSION); }

}  // namespace

ProgramOptions::ProgramOptions(const std::string& about, const std::string& program)
    : app_(std::make_shared<CLI::App>(about, program)) {
  add_version(*app_);
}

ProgramOption ProgramOptions::add_option(const std::string& name, OptionTarget target,
                                         const std::string& about) {
  return ProgramOption(
      std::visit([&](auto* value) { return app_->add_option(name, *value, about); }, target));
}

ProgramOption ProgramOptions::add_flag(const std::string& name, bool* target, const std::string& about) {
  return ProgramOption(app_->add_flag(name, *target, about));
}

ProgramOptions ProgramOptions::add_subcommand(const std::string& name, const std::string& about) {
  CLI::App* subcommand = app_->add_subcommand(name, about);
  app_->require_subcommand(1);
  add_version(*subcommand);
  return ProgramOptions(app_->get_subcommand_ptr(subcommand));
}

void ProgramOptions::describe_help(const std::string& about) { app_->set_help_flag("-h,--help", about); }

const std::string& ProgramOptions::name() const { return app_->get_name(); }

bool ProgramOptions::is_chosen() const { return app_->parsed(); }

int ProgramOptions::run(int argc, char** argv, const std::function<int()>& program) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return run_and_flush([&]() -> int { return app_->exit(error) == 0 ? exit_done : exit_input_error; });
  }
  return run_main([&] { return run_guarded(program); });
}

}  // namespace trivium
