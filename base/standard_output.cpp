#include "base/standard_output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <system_error>

#include "base/exit_code.hpp"

namespace trivium {

namespace {

int output_lost(const std::error_code& reason) {
  complain("the results could not be written to stdout: " + reason.message());
  return exit_output_lost;
}

}  // namespace

void complain(const std::string& message) { std::fputs(("error: " + message + "\n").c_str(), stderr); }

int run_and_flush(const std::function<int()>& program) {
  int exit_code = exit_done;
  try {
    exit_code = program();
  } catch (const std::system_error& error) {  // thrown by fmt::print
    if (std::ferror(stdout)) return output_lost(error.code());
    complain(error.what());
    return exit_output_lost;
  }
  errno = 0;
  std::cout.flush();  // CLI11 prints the help text to std::cout
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    return output_lost({errno != 0 ? errno : EIO, std::generic_category()});
  return exit_code;
}

}  // namespace trivium
