/// Faults: forces that overflow, steps that underflow, memory and disks that are full, signals. The program
/// `trivium` runs as a child process. Its exit code and its message must say what happened, and what was
/// computed must be on disk and valid.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <csignal>
#include <limits>
#include <map>
#include <random>

#include "base/csv.hpp"
#include "base/exit_code.hpp"
#include "integrators/methods.hpp"
#include "scenes/building.hpp"
#include "validation/hard/announcement.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/process.hpp"

namespace trivium::hard {

namespace {

using building::body, building::gravity, building::joint, building::side;
using scenes::Scene, scenes::Vector3, scenes::ground;

/// The number after the last `phrase`; NaN if there is none.
double number_after(const std::string& text, std::string_view phrase) {
  double number = std::numeric_limits<double>::quiet_NaN();
  if (const std::size_t at = text.rfind(phrase); at != text.npos)
    std::from_chars(text.data() + at + phrase.size(), text.data() + text.size(), number);
  return number;
}

/// The numbers of the last line of a motion, or what is wrong with the file.
struct Motion {
  std::vector<double> last;
  std::string wrong;

  explicit Motion(const Run& run) {
    if (!run.motion) {
      wrong = "there is no CSV file";
      return;
    }
    try {
      const auto lines = parse_csv(*run.motion);
      if (lines.empty()) wrong = "the CSV file is empty";
      for (std::size_t k = 1; k < lines.size() && wrong.empty(); ++k) {
        const double before = last.empty() ? -1 : last[0];
        last.clear();
        for (const std::string& field : lines[k]) {
          double number = std::numeric_limits<double>::quiet_NaN();
          const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
          if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(number))
            wrong = fmt::format("line {} of the CSV file has the number {}", k + 1, field);
          last.push_back(number);
        }
        if (last.size() != lines[0].size() || !(last[0] > before))
          wrong = fmt::format("line {} of the CSV file is no later state", k + 1);
      }
    } catch (const Error& error) {
      wrong = error.what();
    }
  }
};

/// What is wrong with a run that nothing may harm; empty if nothing.
std::string harm_of(const Run& run, double end) {
  const Motion motion(run);
  if (run.ended.exit_code != exit_done) return "ended with " + run.ended.text() + ": " + run.ended.err;
  if (!run.ended.err.empty()) return "warned: " + run.ended.err;
  if (!motion.wrong.empty()) return motion.wrong;
  if (motion.last.empty() || motion.last[0] != end) return "the CSV file does not reach the end";
  return run.ended.out.empty() ? "there is no report" : "";
}

/// What is wrong with a run that an error of the motion ended.
std::string missing_in_failure(const Run& run) {
  if (run.ended.exit_code != exit_solver_failed) return "ended with " + run.ended.text();
  const std::string message = run.ended.err.substr(0, run.ended.err.find('\n'));
  if (!message.starts_with("error: ")) return "no error message";
  if (const std::string missing = missing_in_announcement(message, {}); !missing.empty()) return missing;
  if (!std::isfinite(number_after(message, "t = "))) return "the time is no number";
  const Motion motion(run);
  if (!motion.wrong.empty()) return motion.wrong;
  if (motion.last.empty()) return "the CSV file is empty";
  return motion.last[0] == number_after(run.ended.err, "holds the motion until t = ")
             ? ""
             : "the CSV file does not end where the message says";
}

/// The row of a case that violates nothing or something, as `wrong` says.
Row settled(Row row, const std::string& wrong, const std::string& why) {
  row.value = wrong.empty() ? 0 : 1;
  row.threshold = 0.5;
  row.verdict = !wrong.empty() ? Verdict::fails : row.is_twin ? Verdict::survives : Verdict::announces;
  row.why = wrong.empty() ? why : wrong + (why.empty() ? "" : "; ") + why;
  std::replace(row.why.begin(), row.why.end(), '\n', ' ');
  return row;
}

/// Calls visit(formulation, name, options) for every method of the list, with chosen and with given steps.
template <class Visit>
void for_every_method(const Judge& judge, std::vector<std::string> methods, bool also_given,
                      const Visit& visit) {
  for (const std::string& formulation : judge.formulations())
    for (const std::string& method : methods) {
      const integrators::MethodInfo& info = *integrators::find_method(method);
      if (!goes_with(info, formulation)) continue;
      const std::vector<std::string> both{"--formulation", formulation, "--integrator", method};
      if (info.chooses_steps) visit(formulation, method, both);
      if (!info.takes_given_steps || !also_given) continue;
      std::vector<std::string> given = both;
      given.insert(given.end(), {"--step", "0.01"});
      visit(formulation, method + ", h = 0.01", given);
    }
}

// --- a force that is not finite
// -----------------------------------------------------------------------------

constexpr double onset = 0.5;  ///< time [s] at which the push begins

/// A pendulum that is pushed by the force (c t)^4 from the onset on.
Scene pushed_pendulum(double c) {
  const TimeFunction line = TimeFunction::Polynomial{{0, c}},
                     push = TimeFunction::Product{{line, line, line, line}};
  Scene scene;
  scene.name = fmt::format("pushed_pendulum_{:g}", c);
  scene.bodies = {body("rod", 1, {0.1, 0.2, 0.3}, {1, 0, 0})};
  scene.constraints = {joint(JointType::revolute, "hinge", side(ground, Vector3{}, Vector3{0, 1, 0}),
                             side(0, Vector3{-1, 0, 0}, Vector3{0, 1, 0}))};
  Force<double> force;
  force.name = "push";
  force.body = 0;
  force.components[2] = TimeFunction::Piecewise{{onset}, {TimeFunction(0), push}};
  scene.effects = {gravity(), force};
  return scene;
}
