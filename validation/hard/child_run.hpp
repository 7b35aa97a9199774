#pragma once
/// Runs of `trivium simulate` as a child process on a scene in a temporary folder, and what may be wrong with
/// such a run: its exit code, its messages, the files that it leaves. Each answer is one line, empty if
/// nothing is wrong.

#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "validation/hard/announcement.hpp"
#include "validation/hard/process.hpp"

namespace trivium::hard {

/// A run of `trivium simulate --out motion.csv`, and all files that it left: their names and texts.
struct Run {
  Ended ended;
  std::map<std::string, std::string> files;
};

/// A temporary folder with a scene, in which the program runs.
class Workplace {
 public:
  Workplace(std::string program, const scenes::Scene& scene);
  Workplace(const Workplace&) = delete;
  ~Workplace();

  /// Removes the files of an earlier run, and runs the scene. `how`: all of the command but its words. The
  /// path of the folder is left out of the messages.
  Run simulate(const std::vector<std::string>& options, Command how = {}) const;
  /// The path of a file in the folder.
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

 private:
  explicit Workplace(std::string program);

  std::string program_;
  std::filesystem::path folder_;
};

/// motion.csv as a run left it.
class Motion {
 public:
  explicit Motion(const Run& run);

  const std::string& text() const { return text_; }
  /// What is wrong: no file, no state, a line that is cut off, a number that is not finite, times that do not
  /// ascend.
  const std::string& wrong() const { return wrong_; }
  /// The numbers of the last line.
  const std::vector<double>& last() const { return last_; }
  /// The time of the last line [s]; NaN if there is none.
  double end() const { return end_; }

 private:
  void read(std::size_t number, const std::vector<std::string>& line, std::size_t columns);

  std::string text_, wrong_;
  std::vector<double> last_;
  double end_ = std::numeric_limits<double>::quiet_NaN();
};

std::string first_line(const std::string& text);
/// Whether the text is the beginning of the other one, with whole lines.
bool begins(const std::string& text, const std::string& whole);

/// Of a run that nothing may harm or warn of.
std::string wrong_unharmed(const Run& run, double end);
/// Of a run of the scene from time 0 on that an error of the motion ended before `end`, after it has
/// `reached` a time.
std::string wrong_in_failure(const Run& run, const scenes::Scene& scene, double end, double reached,
                             const std::string& reason);
/// Of a run that may end early with a message if it cannot go on; `whole` is the same run unharmed.
std::string wrong_in_loss(const Run& run, const Run& whole);
/// Of a run that a signal ended; `whole` is a run to an earlier or later end.
std::string wrong_after_signal(const Run& run, const Run& whole, int signal);

}  // namespace trivium::hard
