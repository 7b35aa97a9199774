/// Question: how many instructions does one evaluation of accelerations and multipliers take? The program
/// runs itself under callgrind, which counts instructions. Unlike a time, this number does not depend on
/// other load of the machine, so that a regression of the solver is visible. The program fails only if
/// valgrind cannot count.

#include <fmt/format.h>
#include <stdio.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "base/error.hpp"
#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "formulations/formulation_list.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/harness/program.hpp"
#include "validation/harness/timed_formulations.hpp"

namespace trivium {

namespace {

struct Workload {
  std::string scene, formulation;
  int n = 0;
  bool refined = false;
};

scenes::Scene scene_of(const Workload& w) {
  return w.scene == "chain" ? scenes::chain(w.n) : scenes::ladder(w.n);
}

template <Formulation F>
void walk(const Workload& w, int evaluations) {
  const scenes::Scene scene = scene_of(w);
  const auto mechanism = make_mechanism<double>(scene);
  const auto state = make_state<double>(scene);
  const auto bodies = to_coordinates<F>(mechanism, state, {});
  AccelerationSolver<F> solver(mechanism);
  for (int k = 0; k < evaluations; ++k)
    solver.solve(bodies, state.t, w.refined ? Refinement::as_needed : Refinement::none);
}

void walk(const Workload& w, int evaluations) {
  with_formulation<double>(w.formulation, [&]<class F>() { walk<F>(w, evaluations); });
}

/// The number of instructions of this program when it solves the workload `evaluations` times.
long long count(const Workload& w, int evaluations) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = fmt::format(
      "valgrind --tool=callgrind --callgrind-out-file=/dev/null '{}' --walk {} --size {} "
      "--formulation {} --evaluations {}{} 2>&1",
      self, w.scene, w.n, w.formulation, evaluations, w.refined ? " --refined" : "");
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) throw ModelError("cannot start a shell to run valgrind");
  std::string said;
  for (char block[4096]; fgets(block, sizeof block, pipe.get());) said += block;
  const std::string key = "Collected : ";
  const std::size_t at = said.find(key);
  if (at == std::string::npos)
    throw ModelError(
        fmt::format("valgrind returned no instruction count; is valgrind installed? Its output:\n{}", said));
  return std::stoll(said.substr(at + key.size()));
}

struct Answer {
  Workload workload;
  int bodies = 0;
  long long instructions = 0;

  double per_body() const { return static_cast<double>(instructions) / bodies; }
};

/// The instructions of one evaluation: from the difference of two counts, in which the cost of building the
/// mechanism and the solver cancels. One-off work of the first two evaluations is in both counts and cancels
/// as well. Ten evaluations make up the difference: fewer average less, more take longer under valgrind.
Answer ask(const Workload& w) {
  constexpr int few = 2, many = 12;
  Answer answer{w, static_cast<int>(scene_of(w).bodies.size()), 0};
  answer.instructions = (count(w, many) - count(w, few)) / (many - few);
  return answer;
}

const std::vector<std::string> columns{"scene",      "bodies",       "formulation",
                                       "refinement", "instructions", "instructions_per_body"};

std::vector<std::string> fields(const Answer& a) {
  return {fmt::format("{}_{}", a.workload.scene, a.workload.n),
          std::to_string(a.bodies),
          a.workload.formulation,
          a.workload.refined ? "once" : "none",
          std::to_string(a.instructions),
          fmt::format("{:.0f}", a.per_body())};
}

std::string json_of(const std::vector<Answer>& answers) {
  JsonWriter json;
  json.begin_object().begin_array("workloads");
  for (const Answer& a : answers) {
    json.begin_object().text("scene", fmt::format("{}_{}", a.workload.scene, a.workload.n));
    json.number("bodies", a.bodies).text("formulation", a.workload.formulation);
    json.text("refinement", a.workload.refined ? "once" : "none").number("instructions", a.instructions);
    json.end_object();
  }
  return json.end_array().end_object().str();
}

int run(const Program& program) {
  std::vector<Workload> workloads;
  for (const auto& [scene, n] : {std::pair("chain", 10), std::pair("chain", 100), std::pair("ladder", 40)})
    for (const std::string& formulation : TimedFormulations::names())
      for (const bool refined : {false, true}) workloads.push_back({scene, formulation, n, refined});
  Progress progress("instruction_counts", workloads.size());
  std::vector<Answer> answers;
  for (const Workload& w : workloads) {
    answers.push_back(ask(w));
    progress.step();
  }
  ResultsFile file("instruction_counts", columns);
  Table table(columns);
  for (const Answer& a : answers) {
    file.add(fields(a));
    table.add(fields(a));
  }
  program.write(file);
  fmt::print("{}", program.json() ? json_of(answers) : table.text());
  return 0;
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  Program program(
      "How many instructions does one evaluation of accelerations and multipliers take? Measured on "
      "chains of 10 and 100 bodies and a ladder of 40 loops, in r-omega, r-p and r-epsilon, with and "
      "without refinement.",
      "instruction_counts", "");
  Workload workload;
  int evaluations = 0;
  // hidden options with which the program calls itself under valgrind
  ProgramOptions& options = program.options();
  options.add_option("--walk", &workload.scene).hide();
  options.add_option("--size", &workload.n).hide();
  options.add_option("--formulation", &workload.formulation).hide();
  options.add_option("--evaluations", &evaluations).hide();
  options.add_flag("--refined", &workload.refined).hide();
  return program.run(argc, argv, [&] {
    if (workload.scene.empty()) return run(program);
    walk(workload, evaluations);
    return 0;
  });
}
