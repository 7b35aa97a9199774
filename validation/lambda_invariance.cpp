/// Is lambda the same number in every formulation? For catalogue scenes and random mechanisms, the largest
/// relative difference of lambda between formulations, in the norm of E = diag(Phi M^-1 Phi^T)^(1/2), against
/// 100 u kappa.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

#include "bodies/error.hpp"
#include "formulations/side_by_side.hpp"
#include "validation/catalogue.hpp"
#include "validation/progress.hpp"
#include "validation/random_mechanism.hpp"
#include "validation/results_file.hpp"
#include "validation/text_output.hpp"

namespace trivium {

namespace {

struct Arguments {
  std::vector<std::string> scenes;
  std::optional<int> random;  ///< default 200, or none beside scenes named on the command line
  std::uint64_t seed = 1;
  bool json = false, all_rows = false;
  std::string csv;
};

/// The pairs of formulations that are compared, by index into formulation_names().
struct Pair {
  std::size_t a, b;
  const char* name;
};
constexpr Pair pairs[] = {{0, 1, "r-omega/r-p"},
                          {0, 2, "r-omega/r-epsilon"},
                          {1, 2, "r-p/r-epsilon"},
                          {0, 3, "r-omega/omega-first"}};

enum class Verdict { ok, none, exceeds, error };

std::string name_of(Verdict v) {
  switch (v) {
    case Verdict::ok:
      return "ok";
    case Verdict::none:
      return "none";  // no multiplier is unique, nothing to compare
    case Verdict::exceeds:
      return "EXCEEDS";
    case Verdict::error:
      return "ERROR";
  }
  return "";
}

struct Answer {
  std::string scene, error;
  int nb = 0, nc = 0, rank = 0;
  double kappa = 0, bound = 0;
  std::vector<double> difference;
  Verdict verdict = Verdict::error;

  double worst() const {
    return difference.empty() ? 0.0 : *std::max_element(difference.begin(), difference.end());
  }
};

Answer ask(const scenes::Scene& scene, double t) {
  Answer answer;
  answer.scene = scene.name;
  SolveOptions options;
  options.estimate_errors = false;
  const SideBySide<double> result = solve_side_by_side<double>(scene, t, options);
  answer.nb = static_cast<int>(scene.bodies.size());
  answer.nc = static_cast<int>(result.rows.unique.size());
  answer.rank = result.rows.rank;
  answer.kappa = result.rows.kappa;
  answer.bound = 100 * unit_roundoff<double>() * answer.kappa;
  for (const auto& f : result.formulations)
    if (!f.error.empty()) {
      answer.error = fmt::format("{}: {}", f.name, f.error);
      return answer;
    }
  for (const Pair& pair : pairs)
    answer.difference.push_back(lambda_distance(result.rows, result.formulations[pair.a].solution.lambda,
                                                result.formulations[pair.b].solution.lambda));
  // written so that a difference that is not a number is not "ok"
  answer.verdict = !result.any_unique()             ? Verdict::none
                   : answer.worst() <= answer.bound ? Verdict::ok
                                                    : Verdict::exceeds;
  return answer;
}

std::vector<std::string> columns() {
  std::vector<std::string> names{"scene", "nb", "nc", "rank", "kappa"};
  for (const Pair& pair : pairs) names.push_back(pair.name);
  names.insert(names.end(), {"bound", "verdict"});
  return names;
}

/// `number` writes a number.
template <class Number>
std::vector<std::string> fields(const Answer& a, const Number& number) {
  std::vector<std::string> out{a.scene, std::to_string(a.nb), std::to_string(a.nc), std::to_string(a.rank),
                               number(a.kappa)};
  const bool comparable = a.verdict == Verdict::ok || a.verdict == Verdict::exceeds;
  for (std::size_t k = 0; k < std::size(pairs); ++k)
    out.push_back(comparable ? number(a.difference[k]) : "none");
  out.push_back(number(a.bound));
  out.push_back(name_of(a.verdict));
  return out;
}

std::string short_number(double x) { return fmt::format("{:.1e}", x); }

class Survey {
 public:
  void add(Answer answer) { answers_.push_back(std::move(answer)); }
  bool passed() const {
    return std::all_of(answers_.begin(), answers_.end(), [](const Answer& a) {
      return a.verdict == Verdict::ok || a.verdict == Verdict::none;
    });
  }
  const std::vector<Answer>& answers() const { return answers_; }

  /// All answers; of many random ones only the worst and what failed, with a line that sums them up.
  std::string text(std::size_t scenes, bool all_rows) const {
    Table table(columns());
    for (std::size_t k = 0; k < answers_.size(); ++k)
      if (k < scenes || all_rows || answers_[k].verdict == Verdict::exceeds ||
          answers_[k].verdict == Verdict::error)
        table.add(fields(answers_[k], short_number));
    std::string out = table.text();
    for (const Answer& a : answers_)
      if (!a.error.empty()) out += fmt::format("{}: {}\n", a.scene, a.error);
    if (answers_.size() > scenes) out += random_summary(scenes);
    return out;
  }

  std::string json() const {
    JsonWriter json;
    json.begin_object().flag("passed", passed()).begin_array("scenes");
    for (const Answer& a : answers_) {
      json.begin_object()
          .text("scene", a.scene)
          .number("nb", a.nb)
          .number("nc", a.nc)
          .number("rank", a.rank)
          .number("kappa", a.kappa);
      if (!a.difference.empty()) {
        json.begin_object("difference");
        for (std::size_t k = 0; k < std::size(pairs); ++k) json.number(pairs[k].name, a.difference[k]);
        json.end_object();
      }
      json.number("bound", a.bound).text("verdict", name_of(a.verdict));
      if (!a.error.empty()) json.text("error", a.error);
      json.end_object();
    }
    return json.end_array().end_object().str();
  }

 private:
  std::string random_summary(std::size_t from) const {
    std::vector<double> ratio, difference;
    std::size_t none = 0;
    for (std::size_t k = from; k < answers_.size(); ++k) {
      const Answer& a = answers_[k];
      if (a.verdict == Verdict::none) ++none;
      if (a.difference.empty() || a.verdict == Verdict::none) continue;
      difference.push_back(a.worst());
      ratio.push_back(100 * a.worst() / a.bound);
    }
    if (ratio.empty())
      return fmt::format("{} random mechanisms: no unique multipliers\n", answers_.size() - from);
    std::sort(ratio.begin(), ratio.end());
    std::sort(difference.begin(), difference.end());
    return fmt::format(
        "{} random mechanisms ({} without unique multipliers): difference {:.1e} median, {:.1e} worst; in "
        "units of u kappa "
        "{:.2g} median, {:.2g} worst (bound 100)\n",
        answers_.size() - from, none, difference[difference.size() / 2], difference.back(),
        ratio[ratio.size() / 2], ratio.back());
  }

  std::vector<Answer> answers_;
};

int run(const Arguments& arguments, int argc, char** argv) {
  const int random_count = arguments.random.value_or(arguments.scenes.empty() ? 200 : 0);
  std::vector<std::string> scenes = arguments.scenes;
  if (scenes.empty())
    for (const auto& file : catalogue()) scenes.push_back(file.string());
  Survey survey;
  Progress progress("lambda_invariance", scenes.size() + static_cast<std::size_t>(random_count));
  for (const std::string& file : scenes) {
    survey.add(ask(load_consistent_scene(file, 0), 0));
    progress.step();
  }
  for (int k = 0; k < random_count; ++k) {
    const RandomMechanism random = random_mechanism(arguments.seed + static_cast<std::uint64_t>(k));
    survey.add(ask(random.scene, random.t));
    progress.step();
  }
  if (!arguments.csv.empty()) {
    ResultsFile file("lambda_invariance", columns());
    for (const Answer& answer : survey.answers()) file.add(fields(answer, results_number));
    file.write(arguments.csv, argc, argv);
  }
  fmt::print("{}", arguments.json ? survey.json() : survey.text(scenes.size(), arguments.all_rows));
  return survey.passed() ? exit_done : exit_criterion_failed;
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  CLI::App app{"Is lambda the same number in every formulation?", "lambda_invariance"};
  Arguments arguments;
  app.set_version_flag("--version", "trivium " TRIVIUM_VERSION);
  app.add_option("SCENE", arguments.scenes, "Scene files or catalogue names (default: the whole catalogue)");
  app.add_option("--random", arguments.random,
                 "How many random mechanisms beside them (default 200, or 0 where scenes are named)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--seed", arguments.seed, "Seed of the first random mechanism")->capture_default_str();
  app.add_flag("--json", arguments.json, "JSON on stdout");
  app.add_flag("--all", arguments.all_rows, "A line for every random mechanism too");
  app.add_option("--csv", arguments.csv, "Write the table to this CSV file, and a manifest beside it");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_input_error;
  }
  return run_guarded([&] { return run(arguments, argc, argv); });
}
