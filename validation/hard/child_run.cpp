#include "validation/hard/child_run.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "base/csv.hpp"
#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "base/whole_file.hpp"
#include "scenes/format/scene_file.hpp"

namespace trivium::hard {

namespace {

constexpr const char *scene_file = "scene.json", *motion_file = "motion.csv",
                     *unfinished_motion = "motion.csv.incomplete-";

bool is_scene(const std::string& text) {
  try {
    scenes::parse_scene(text, scene_file);
    return true;
  } catch (const scenes::SceneError&) {
    return false;
  }
}

}  // namespace

Workplace::Workplace(std::string program) : program_(std::move(program)) {
  std::string name = (std::filesystem::temp_directory_path() / "hard_cases-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw Error(ErrorKind::input, fmt::format("{} cannot be created: {}; accepted: TMPDIR, a folder to write",
                                              name, std::generic_category().message(errno)));
  folder_ = name;
}

Workplace::Workplace(std::string program, const scenes::Scene& scene) : Workplace(std::move(program)) {
  scenes::write_scene_file(file(scene_file), scene);
}

Workplace::~Workplace() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

Run Workplace::simulate(const std::vector<std::string>& options, Command how) const {
  const auto left = [&] {
    std::vector<std::filesystem::path> all;
    for (const std::filesystem::path& entry : std::filesystem::directory_iterator(folder_))
      if (entry.filename() != scene_file) all.push_back(entry);
    return all;
  };
  for (const auto& old : left()) std::filesystem::remove(old);
  how.program = program_;
  how.arguments = {"simulate", file(scene_file), "--out", file(motion_file)};
  how.arguments.insert(how.arguments.end(), options.begin(), options.end());
  Run run{hard::run(how), {}};
  for (const auto& found : left()) run.files[found.filename().string()] = read_whole(found);
  const std::string path = folder_.string() + "/";
  for (std::string* text : {&run.ended.out, &run.ended.err})
    for (std::size_t at; (at = text->find(path)) != text->npos;) text->erase(at, path.size());
  return run;
}

Motion::Motion(const Run& run) {
  const auto file = run.files.find(motion_file);
  if (file == run.files.end()) {
    wrong_ = "there is no CSV file";
    return;
  }
  text_ = file->second;
  try {
    const auto lines = parse_csv(text_);
    if (lines.size() < 2) wrong_ = "the CSV file has no state";
    for (std::size_t k = 1; k < lines.size() && wrong_.empty(); ++k) read(k + 1, lines[k], lines[0].size());
  } catch (const Error& error) {
    wrong_ = error.what();
  }
}

void Motion::read(std::size_t number, const std::vector<std::string>& line, std::size_t columns) {
  last_.clear();
  for (const std::string& field : line) {
    last_.push_back(std::numeric_limits<double>::quiet_NaN());
    const char* stop = field.data() + field.size();
    const auto [read_to, error] = std::from_chars(field.data(), stop, last_.back());
    if (error != std::errc() || read_to != stop || !std::isfinite(last_.back()))
      wrong_ = fmt::format("line {} of the CSV file has the number \"{}\"", number, field);
  }
  if (last_.size() != columns || last_[0] <= end_)
    wrong_ = fmt::format("line {} of the CSV file is not a later state", number);
  end_ = last_[0];
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

bool begins(const std::string& text, const std::string& whole) {
  return whole.starts_with(text) && (text.empty() || text.ends_with('\n'));
}

std::string wrong_unharmed(const Run& run, double end) {
  if (run.ended.exit_code != exit_done)
    return fmt::format("ended with {}: {}", run.ended.text(), first_line(run.ended.err));
  if (!run.ended.err.empty()) return "warned: " + first_line(run.ended.err);
  const Motion motion(run);
  if (!motion.wrong().empty()) return motion.wrong();
  if (motion.end() != end) return "the CSV file does not reach the end";
  return run.ended.out.empty() ? "there is no report" : "";
}

std::string wrong_in_failure(const Run& run, const scenes::Scene& scene, double end, double reached,
                             const std::string& reason) {
  if (run.ended.exit_code != exit_solver_failed) return "ended with " + run.ended.text();
  const std::string message = first_line(run.ended.err);
  if (!message.starts_with("error: ")) return "there is no error message";
  const double when = number_after(message, "t = ");
  if (!std::isfinite(when)) return "the time is not a number";
  if (const std::string missing = missing_in_announcement(message, when, scene, 0, end, reason);
      !missing.empty())
    return missing;
  const Motion motion(run);
  if (!motion.wrong().empty()) return motion.wrong();
  if (motion.end() < reached - 1e-9) return "the CSV file does not hold the state that was reached";
  return motion.end() == number_after(run.ended.err, "motion.csv holds the motion until t = ")
             ? ""
             : "the CSV file does not end where the message says";
}

std::string wrong_in_loss(const Run& run, const Run& whole) {
  const Ended& ended = run.ended;
  if (ended.exit_code == exit_done)
    return run.files == whole.files && ended.out == whole.ended.out ? ""
                                                                    : "exit code 0, but results are missing";
  if (ended.exit_code != exit_output_lost)
    return fmt::format("ended with {}: {}", ended.text(), first_line(ended.err));
  if (ended.err.empty()) return "there is no message";
  if (ended.err.find(unfinished_motion) != ended.err.npos && run.files.empty())
    return "the file of the message is missing";
  for (const auto& [name, text] : run.files) {
    if (!name.starts_with(motion_file)) {
      if (!is_scene(text)) return name + " is not a scene";
    } else if (!begins(text, whole.files.at(motion_file))) {
      return name + " is not the beginning of the motion";
    } else if (name != motion_file && ended.err.find(name) == ended.err.npos) {
      return "no message says where the motion is";
    }
  }
  return "";
}

std::string wrong_after_signal(const Run& run, const Run& whole, int signal) {
  if (run.ended.signal == signal && run.files.empty()) return "";  // the run had not begun
  if (run.ended.exit_code != exit_interrupted) return "ended with " + run.ended.text();
  const Motion motion(run);
  if (!motion.wrong().empty()) return motion.wrong();
  // the last line is the state that was reached, which may lie between two outputs
  const std::string lines = motion.text().substr(0, motion.text().rfind('\n', motion.text().size() - 2) + 1),
                    other = whole.files.at(motion_file);
  if (!begins(lines, other) && !begins(other, lines)) return "the CSV file has other states";
  for (const char* phrase : {"interrupted at t = ", "motion.csv holds the motion until t = "})
    if (number_after(run.ended.err, phrase) != motion.end())
      return "the CSV file does not end where the message says";
  return run.files.size() == 1 ? "" : "other files are left";
}

}  // namespace trivium::hard
