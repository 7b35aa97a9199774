/// Question: is lambda the same number along a motion? Every scene is simulated in every formulation
/// independently. lambda is compared between the runs at equal times, and between the formulations at equal
/// states (simulation/motion_comparison.hpp). The program fails if a run fails, or if a difference exceeds
/// its bound.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/raise.hpp"
#include "base/table.hpp"
#include "integrators/methods.hpp"
#include "simulation/motion_comparison.hpp"
#include "validation/harness/program.hpp"

namespace trivium {

namespace {

struct Arguments {
  std::string integrator = "dopri5";
  double t_end = 2;
};

/// End times [s] of scenes whose published motion is shorter than the default.
const std::map<std::string, double> published_ends{{"andrews_squeezer", 0.03}};

/// The number of outputs at which all formulations are solved at the same states. Each solution needs a dense
/// matrix, whose cost is cubic in the number of bodies; large scenes therefore get fewer. The limit of 30
/// bodies is chosen by experiment.
int states_of(const NamedScene& named) { return named.scene.bodies.size() > 30 ? 3 : 10; }

struct Answer {
  std::string scene, error;
  std::size_t nb = 0;
  int nc = 0;
  double t_end = 0;
  long steps = 0;  ///< largest number of steps of any formulation
  std::size_t outputs = 0, judged = 0;
  bool has_unique_lambda = true, holds = false;
  double amplification = 1;
  // largest values with bounds and ratios to the bounds: lambda of the separate runs over the judged outputs,
  // state_* over the compared states that are not near a singular position
  double lambda = 0, lambda_bound = 0, lambda_ratio = 0;
  double state_lambda = 0, state_kappa = 1, state_ratio = 0;

  void take(const MotionComparison& c) {
    for (const ComparedRun& run : c.runs) {
      if (!run.error.empty() && error.empty())
        error = fmt::format("{}: {}: {}", scene, run.formulation, run.error);
      steps = std::max(steps, run.report.counters.steps);
    }
    has_unique_lambda = c.has_unique_lambda;
    holds = c.holds_along() && c.holds_at_states();
    outputs = c.instants.size();
    for (const ComparedInstant& now : c.instants) {
      if (const auto& at = now.one_state; at && !now.is_singular) {
        raise(state_lambda, at->lambda);
        raise(state_kappa, at->kappa);
        raise(state_ratio, at->lambda / at->bound);
      }
      if (!c.is_judged(now)) continue;
      ++judged;
      raise(amplification, now.amplification);
      raise(lambda, now.lambda);
      raise(lambda_bound, now.lambda_bound);
      raise(lambda_ratio, now.lambda / now.lambda_bound);
    }
  }
  const char* verdict() const {
    return !error.empty() ? "ERROR" : !has_unique_lambda ? "none" : holds ? "ok" : "EXCEEDS";
  }
};

Answer ask(const Arguments& arguments, const NamedScene& named, const std::function<void(double)>& progress) {
  Answer answer;
  answer.scene = named.scene.name;
  answer.nb = named.scene.bodies.size();
  const auto published = published_ends.find(named.scene.name);
  answer.t_end =
      published == published_ends.end() ? arguments.t_end : std::min(arguments.t_end, published->second);
  ComparisonOptions options;
  options.run.integrator = arguments.integrator;
  options.run.end = answer.t_end;
  options.states = states_of(named);
  options.progress = progress;
  try {
    const Model<double>& model = named.model();
    answer.nc = model.mechanism.nc();
    answer.take(compare_motion(compared_formulations({}, *integrators::find_method(arguments.integrator)),
                               model, options));
  } catch (const Error& error) {
    answer.error = name_source(named.source, error.what());
  }
  return answer;
}

const std::vector<std::string> columns{
    "scene",  "nb",           "nc",           "t_end",        "steps",       "judged",      "amplification",
    "lambda", "lambda_bound", "lambda_ratio", "state_lambda", "state_kappa", "state_ratio", "verdict"};

template <class Number>
std::vector<std::string> fields(const Answer& a, const Number& number) {
  std::vector<std::string> out{a.scene,
                               std::to_string(a.nb),
                               std::to_string(a.nc),
                               fmt::format("{}", a.t_end),
                               std::to_string(a.steps),
                               fmt::format("{}/{}", a.judged, a.outputs)};
  const bool is_compared = a.error.empty() && a.has_unique_lambda;
  for (const double x : {a.amplification, a.lambda, a.lambda_bound, a.lambda_ratio, a.state_lambda,
                         a.state_kappa, a.state_ratio})
    out.push_back(is_compared ? number(x) : "none");
  out.emplace_back(a.verdict());
  return out;
}

std::string text(const std::vector<Answer>& answers) {
  Table table(columns);
  ErrorLines errors;
  for (const Answer& a : answers) {
    table.add(fields(a, [](double x) { return fmt::format("{:.1e}", x); }));
    if (!a.error.empty()) errors.add(a.error);
  }
  return table.text() + errors.text();
}

std::string json(const std::vector<Answer>& answers) {
  JsonWriter out;
  out.begin_object().begin_array("scenes");
  for (const Answer& a : answers) {
    out.begin_object()
        .text("scene", a.scene)
        .number("nb", a.nb)
        .number("nc", a.nc)
        .number("t_end", a.t_end)
        .text("verdict", a.verdict());
    if (!a.error.empty()) out.text("error", a.error);
    if (a.error.empty() && a.has_unique_lambda)
      out.number("steps", a.steps)
          .number("outputs", a.outputs)
          .number("judged", a.judged)
          .number("amplification", a.amplification)
          .number("lambda", a.lambda)
          .number("lambda_bound", a.lambda_bound)
          .number("lambda_ratio", a.lambda_ratio)
          .number("state_lambda", a.state_lambda)
          .number("state_kappa", a.state_kappa)
          .number("state_ratio", a.state_ratio);
    out.end_object();
  }
  return out.end_array().end_object().str();
}

int run(const Program& program, const Arguments& arguments) {
  const std::vector<NamedScene> scenes = program.scenes(0);
  constexpr std::size_t ticks = 100;
  Progress progress("motion_invariance", ticks * scenes.size());
  std::vector<Answer> answers;
  for (const NamedScene& named : scenes) {
    std::size_t shown = 0;
    const auto tell = [&](double share) {
      for (; static_cast<double>(shown) < share * ticks; ++shown) progress.step();
    };
    answers.push_back(ask(arguments, named, tell));
    tell(1);
  }
  ResultsFile file("motion_invariance", columns);
  for (const Answer& answer : answers) file.add(fields(answer, results_number));
  program.write(file);
  fmt::print("{}", program.json() ? json(answers) : text(answers));
  const auto all = [&](const auto& is) { return std::all_of(answers.begin(), answers.end(), is); };
  return batch_exit(all([](const Answer& a) { return a.error.empty(); }),
                    all([](const Answer& a) { return !a.has_unique_lambda || a.holds; }));
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  Program program("Is lambda the same number in every formulation along a motion?", "motion_invariance");
  Arguments arguments;
  program.options()
      .add_option("--integrator", &arguments.integrator, "Integration method; must choose its step size")
      .one_of(integrators::method_names())
      .show_default();
  program.options()
      .add_option("--t-end", &arguments.t_end,
                  "End of the motions [s]; a motion with a shorter published end stops there")
      .check(positive_number())
      .show_default();
  return program.run(argc, argv, [&] { return run(program, arguments); });
}
