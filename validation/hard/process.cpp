#include "validation/hard/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <initializer_list>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.hpp"

namespace trivium::hard {

namespace {

[[noreturn]] void refuse(const std::string& program, int why) {
  throw Error(ErrorKind::input, fmt::format("--program: {} cannot be started: {}; accepted: the path of the "
                                            "program trivium",
                                            program, std::generic_category().message(why)));
}

/// A file descriptor that is closed at the end and not inherited.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close() {
    if (is_open()) ::close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

struct Pipe {
  Descriptor read, write;

  explicit Pipe(const std::string& program) {
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0) refuse(program, errno);
    read = Descriptor(ends[0]);
    write = Descriptor(ends[1]);
  }
};

/// Whether the list sets the variable of this NAME=VALUE.
bool is_set(const std::vector<std::string>& list, std::string_view variable) {
  const std::string_view name = variable.substr(0, variable.find('=') + 1);
  return std::any_of(list.begin(), list.end(), [&](const std::string& one) { return one.starts_with(name); });
}

/// The words with a null at the end, as exec takes them.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

void limit(decltype(RLIMIT_CORE) resource, std::uint64_t most) {
  const rlimit both{most, most};
  setrlimit(resource, &both);
}

/// Becomes the program. The other threads are gone, perhaps with locks: only calls that need none follow.
[[noreturn]] void become(const Command& command, char* const* arguments, char* const* environment, int in,
                         int out, int err, int failure) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ}) std::signal(number, SIG_DFL);
  if (!command.raises_at_largest_file) std::signal(SIGXFSZ, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  limit(RLIMIT_CORE, 0);
  if (command.largest_file) limit(RLIMIT_FSIZE, *command.largest_file);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  execve(arguments[0], arguments, environment);
  const int why = errno;
  while (write(failure, &why, sizeof why) < 0 && errno == EINTR) {
  }
  _exit(127);
}

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Reads what is there, and closes the descriptor at its end.
void take(Descriptor& from, std::string& text) {
  std::array<char, 65536> buffer;
  const ssize_t length = read(from.number(), buffer.data(), buffer.size());
  if (length > 0)
    text.append(buffer.data(), static_cast<std::size_t>(length));
  else if (length == 0 || errno != EINTR)
    from.close();
}

/// Collects the output of the process until it ends, and sends the signals in time.
void attend(pid_t process, const Command& command, Descriptor& out, Descriptor& err, Ended& ended) {
  const Clock::time_point start = Clock::now();
  std::optional<Kill> kill = command.kill;
  while (out.is_open() || err.is_open()) {
    const double now = seconds_since(start);
    if (kill && now >= kill->after) {
      ::kill(process, kill->signal);
      kill.reset();
    }
    if (now >= command.most_seconds && !ended.is_late) {
      ::kill(-process, SIGKILL);  // and what it has started
      ended.is_late = true;
    }
    double until = ended.is_late ? now + 1 : command.most_seconds;
    if (kill) until = std::min(until, kill->after);
    std::array<pollfd, 2> watched{pollfd{out.number(), POLLIN, 0}, pollfd{err.number(), POLLIN, 0}};
    const double milliseconds = std::clamp(std::ceil((until - now) * 1000), 0.0, 1e6);
    if (poll(watched.data(), watched.size(), static_cast<int>(milliseconds)) <= 0) continue;
    if (watched[0].revents != 0) take(out, ended.out);
    if (watched[1].revents != 0) take(err, ended.err);
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) ended.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  ended.seconds = seconds_since(start);
}

}  // namespace

std::string Ended::text() const {
  if (is_late) return fmt::format("no end within {:.0f} s", seconds);
  return signal != 0 ? fmt::format("signal {} ({})", signal, strsignal(signal))
                     : fmt::format("exit code {}", exit_code);
}

Ended run(const Command& command) {
  std::vector<std::string> words{command.program}, variables;
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!is_set(command.environment, *variable)) variables.emplace_back(*variable);
  variables.insert(variables.end(), command.environment.begin(), command.environment.end());
  const std::vector<char*> arguments = pointers(words), environment = pointers(variables);
  Descriptor in(open("/dev/null", O_RDONLY | O_CLOEXEC)), to_file;
  Pipe out(command.program), err(command.program), failure(command.program);
  if (!command.out_file.empty())
    to_file = Descriptor(open(command.out_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600));
  if (!in.is_open() || (!command.out_file.empty() && !to_file.is_open())) refuse(command.program, errno);

  const pid_t process = fork();
  if (process < 0) refuse(command.program, errno);
  if (process == 0)
    become(command, arguments.data(), environment.data(), in.number(),
           to_file.is_open() ? to_file.number() : out.write.number(), err.write.number(),
           failure.write.number());
  out.write.close();
  err.write.close();
  failure.write.close();
  Ended ended;
  attend(process, command, out.read, err.read, ended);
  int why = 0;
  if (read(failure.read.number(), &why, sizeof why) == static_cast<ssize_t>(sizeof why))
    refuse(command.program, why);
  return ended;
}

}  // namespace trivium::hard
