#include "base/command_line.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "base/standard_output.hpp"

namespace trivium {

int run_guarded(const std::function<int()>& program) {
  return run_and_flush([&]() -> int {
    try {
      return program();
    } catch (const Error& error) {
      complain(error.what());
      return error.kind() == ErrorKind::input ? exit_input_error : exit_solver_failed;
    } catch (const std::filesystem::filesystem_error& error) {
      complain(error.what());
      return exit_input_error;
    }
  });
}

ExitCode batch_exit(bool all_solved, bool all_passed) {
  return !all_solved ? exit_solver_failed : all_passed ? exit_done : exit_criterion_failed;
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

}  // namespace trivium
