#include "validation/hard/losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "base/exit_code.hpp"
#include "base/number_text.hpp"
#include "integrators/methods.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/child_run.hpp"
#include "validation/hard/fault_rows.hpp"
#include "validation/hard/methods.hpp"

namespace trivium::hard {

namespace {

/// A method that is tried in one formulation, and how often.
struct Tried {
  std::string formulation, method;
  Options options;
  double tries;

  Row row(const Judge& judge, const std::string& what) const {
    return row_of_end(judge, formulation, method + ", " + what);
  }
};

/// The methods of a list. The first makes all tries, others a sixteenth: most of the code that they try is
/// the same.
std::vector<Tried> methods_to_try(const Judge& judge, const std::string& list, double tries) {
  std::vector<Tried> all;
  for (const std::string& method : methods_of(list, judge.is_quick())) {
    const integrators::MethodInfo& info = *integrators::find_method(method);
    for (const std::string& formulation : judge.formulations()) {
      if (!goes_with(info, formulation)) continue;
      Options options{"--formulation", formulation, "--integrator", method};
      if (!info.chooses_steps) options = options + Options{"--step", "0.001"};
      all.push_back({formulation, method, options, all.empty() ? tries : std::ceil(tries / 16)});
      break;
    }
  }
  return all;
}

/// Afterwards there is memory again, or not.
void judge_allocations_of(Judge& judge, const Tried& tried) {
  const Workplace place(judge.choice().program, pushed_pendulum(0));
  const Options options = tried.options + Options{"--t-end", "0.02",       "--output-step",
                                                  "0.005",   "--save-end", place.file("end.json")};
  const std::string preload = "LD_PRELOAD=" TRIVIUM_FAILING_ALLOCATOR;
  Command counting;
  counting.environment = {preload, "TRIVIUM_ALLOCATION_COUNT_FILE=" + place.file("count")};
  Run whole = place.simulate(options, counting);
  const double all = whole.files.contains("count") ? std::stod(whole.files["count"]) : 0,
               tries = std::min(tried.tries, all);
  whole.files.erase("count");
  const std::string harm = all > 0 ? wrong_unharmed(whole, 0.02) : "allocations are not counted";
  if (!harm.empty()) return settle(judge, tried.row(judge, "no allocation fails"), false, {harm}, "");
  for (const bool is_once : {true, false}) {
    std::vector<std::string> wrong;
    std::map<std::string, int> ends;
    bool announced = false;
    for (double k = 0; k < tries; ++k) {
      const long first = 1 + static_cast<long>(k * all / tries),
                 last = is_once ? first : std::numeric_limits<long>::max();
      Command failing;
      failing.environment = {preload, fmt::format("TRIVIUM_FIRST_FAILING_ALLOCATION={}", first),
                             fmt::format("TRIVIUM_LAST_FAILING_ALLOCATION={}", last)};
      const Run run = place.simulate(options, failing);
      ++ends[run.ended.text()];
      announced = announced || run.ended.exit_code != exit_done;
      if (const std::string lost = wrong_in_loss(run, whole); !lost.empty())
        wrong.push_back(fmt::format("allocation {}: {}", first, lost));
    }
    std::string why = fmt::format("{} of {} allocations", tries, all);
    for (const auto& [end, count] : ends) why += fmt::format(", {} times {}", count, end);
    settle(judge, tried.row(judge, is_once ? "one allocation fails" : "all fail from one on"), announced,
           wrong, why);
  }
}

void judge_full_disk_of(Judge& judge, const Tried& tried, double bytes) {
  const Workplace place(judge.choice().program, pushed_pendulum(0));
  const Options options = tried.options + Options{"--t-end", "0.5",        "--output-step",
                                                  "0.01",    "--save-end", place.file("end.json")};
  const Run whole = place.simulate(options);
  if (const std::string wrong = wrong_unharmed(whole, 0.5); !wrong.empty())
    return settle(judge, tried.row(judge, "an empty disk"), false, {wrong}, "");
  for (const bool raises : {false, true}) {
    Command how;
    how.largest_file = static_cast<std::uint64_t>(bytes);
    how.raises_at_largest_file = raises;
    const Run run = place.simulate(options, how);
    std::string wrong = judge.is_twin() ? wrong_unharmed(run, 0.5) : wrong_in_loss(run, whole);
    if (wrong.empty() && !Motion(run).text().empty() && Motion(run).text() != Motion(whole).text())
      wrong = "motion.csv is not whole";
    settle(judge, tried.row(judge, raises ? "limited files (SIGXFSZ)" : "full disk"),
           run.ended.exit_code != exit_done, {wrong}, run.ended.err);
  }
  if (judge.is_twin()) return;
  Command how;
  how.out_file = "/dev/full";
  const Run run = place.simulate(options, how);
  std::string wrong =
      run.ended.exit_code == exit_done ? "exit code 0 without a report" : wrong_in_loss(run, whole);
  if (wrong.empty() && run.files != whole.files) wrong = "files are not whole";
  settle(judge, tried.row(judge, "full stdout"), true, {wrong}, run.ended.err);
}

/// Each run would take minutes at least, and gets the signal at a random time within half a second.
void judge_signal_of(Judge& judge, const Tried& tried, int signal, const char* name, std::mt19937& random) {
  const Workplace place(judge.choice().program, pushed_pendulum(0));
  const auto options = [&](const char* end) {
    return tried.options + Options{"--output-step", "0.05", "--t-end", end};
  };
  const Run whole = place.simulate(options("2"));
  if (const std::string wrong = wrong_unharmed(whole, 2); !wrong.empty())
    return settle(judge, tried.row(judge, name), false, {wrong}, "");
  std::vector<std::string> wrong;
  int interrupted = 0;
  for (double k = 0; k < tried.tries; ++k) {
    Command how;
    const double share = static_cast<double>(random()) / 0x1p32;
    how.kill = Kill{signal, k == 0 ? (1 + share) / 4 : share / 2};  // one late, so that the run has begun
    const Run run = place.simulate(options("1e7"), how);
    if (run.ended.exit_code == exit_interrupted) ++interrupted;
    if (const std::string lost = wrong_after_signal(run, whole, signal); !lost.empty())
      wrong.push_back(fmt::format("after {:.3f} s: {}", how.kill->after, lost));
  }
  if (tried.tries > 0 && interrupted == 0) wrong.emplace_back("no run was interrupted");
  settle(judge, tried.row(judge, name), interrupted > 0, wrong,
         counted(static_cast<long>(tried.tries), "run", "runs"));
}

void judge_signal(Judge& judge, double runs, int signal, const char* name) {
  std::mt19937 random(1);
  for (const Tried& tried : methods_to_try(judge, "faults", runs))
    judge_signal_of(judge, tried, signal, name, random);
}

}  // namespace

void judge_allocations(Judge& judge, double tries) {
  const std::vector<Tried> all = methods_to_try(judge, "failing_allocation", tries);
  for (const Tried& tried : all) {
    if (TRIVIUM_ALLOCATIONS_CAN_FAIL) {
      judge_allocations_of(judge, tried);
      continue;
    }
    Row row = tried.row(judge, "failing allocations");
    row.value = std::numeric_limits<double>::quiet_NaN();
    row.verdict = Verdict::not_judged;
    row.why = "this build has the allocator of a sanitizer";
    judge.add(row);
  }
}

void judge_full_disk(Judge& judge, double bytes) {
  for (const Tried& tried : methods_to_try(judge, "faults", 1)) judge_full_disk_of(judge, tried, bytes);
}

void judge_interrupt(Judge& judge, double runs) { judge_signal(judge, runs, SIGINT, "SIGINT"); }
void judge_termination(Judge& judge, double runs) { judge_signal(judge, runs, SIGTERM, "SIGTERM"); }

}  // namespace trivium::hard
