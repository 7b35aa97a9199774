/// Compares pairs of formulations at the state of every scene, and writes the differences as a table, JSON
/// and CSV.

#include "validation/harness/lambda_invariance.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "base/error.hpp"
#include "base/json_writer.hpp"
#include "base/number_text.hpp"
#include "base/option_checks.hpp"
#include "base/progress.hpp"
#include "base/raise.hpp"
#include "base/table.hpp"
#include "validation/harness/consistent_random_scene.hpp"
#include "validation/harness/program.hpp"

namespace trivium {

namespace {

struct Arguments {
  std::optional<std::size_t> random;  ///< number of random mechanisms; default 200, or 0 if scenes are named
  std::uint64_t seed = 1;
  bool all_rows = false;
};

/// Two formulations that are compared, as indices into the list of formulations.
struct Pair {
  std::size_t a, b;
  std::string name;
};
using Pairs = std::vector<Pair>;

/// Pairs the first formulation with every other one, and the second with the third.
Pairs pairs_of(const std::vector<std::string>& names) {
  Pairs list;
  const auto add = [&](std::size_t a, std::size_t b) { list.push_back({a, b, names[a] + "/" + names[b]}); };
  for (std::size_t b = 1; b < names.size(); ++b) {
    add(0, b);
    if (b == 2) add(1, 2);
  }
  return list;
}

enum class Verdict {
  ok,
  none,     ///< no multiplier is unique, so that nothing can be compared
  cancels,  ///< exceeds the bound by at most the factor cancellation(), by which terms cancel
  exceeds,
  error
};

std::string name_of(Verdict v) {
  switch (v) {
    case Verdict::ok:
      return "ok";
    case Verdict::none:
      return "none";
    case Verdict::cancels:
      return "cancels";
    case Verdict::exceeds:
      return "EXCEEDS";
    case Verdict::error:
      return "ERROR";
  }
  return "";
}

struct Answer {
  std::string scene, error;
  bool analysed = false;  ///< nc, rank, kappa and bound are known
  int nb = 0, nc = 0, rank = 0;
  double kappa = 0, bound = 0, cancellation = 1;
  std::vector<double> difference;
  Verdict verdict = Verdict::error;

  bool comparable() const {
    return verdict == Verdict::ok || verdict == Verdict::cancels || verdict == Verdict::exceeds;
  }
  double worst() const {
    double largest = 0;
    for (const double x : difference) raise(largest, x);
    return largest;
  }
};

void compare(const ComparedFormulations& formulations, const Pairs& pairs, const Model<double>& model,
             Answer& answer) {
  const SideBySide<double> result = formulations.solve(model);
  answer.analysed = true;
  answer.nc = static_cast<int>(result.rows.unique.size());
  answer.rank = result.rows.rank;
  answer.kappa = result.rows.kappa;
  answer.cancellation = result.cancellation();
  answer.bound = result.lambda_bound();
  result.require_solved();
  for (const Pair& pair : pairs)
    answer.difference.push_back(lambda_distance(result.rows, result.formulations[pair.a].solution.lambda,
                                                result.formulations[pair.b].solution.lambda));
  // written so that NaN is not "ok"
  answer.verdict = !result.any_unique()                                   ? Verdict::none
                   : answer.worst() <= answer.bound                       ? Verdict::ok
                   : answer.worst() <= answer.bound * answer.cancellation ? Verdict::cancels
                                                                          : Verdict::exceeds;
}

Answer ask(const ComparedFormulations& formulations, const Pairs& pairs, const NamedScene& named) {
  Answer answer;
  answer.scene = named.scene.name;
  answer.nb = static_cast<int>(named.scene.bodies.size());
  try {
    compare(formulations, pairs, named.model(), answer);
  } catch (const ModelError& error) {
    answer.error = name_source(named.source, error.what());
  }
  return answer;
}

std::vector<std::string> columns(const Pairs& pairs) {
  std::vector<std::string> names{"scene", "nb", "nc", "rank", "kappa"};
  for (const Pair& pair : pairs) names.push_back(pair.name);
  names.insert(names.end(), {"bound", "verdict"});
  return names;
}

/// The fields of one row; `number` formats a number.
template <class Number>
std::vector<std::string> fields(const Pairs& pairs, const Answer& a, const Number& number) {
  const auto known = [&](const std::string& text) { return a.analysed ? text : std::string("none"); };
  std::vector<std::string> out{a.scene, std::to_string(a.nb), known(std::to_string(a.nc)),
                               known(std::to_string(a.rank)), known(number(a.kappa))};
  for (std::size_t k = 0; k < pairs.size(); ++k)
    out.push_back(a.comparable() ? number(a.difference[k]) : "none");
  out.push_back(known(number(a.bound)));
  out.push_back(name_of(a.verdict));
  return out;
}

std::string short_number(double x) { return fmt::format("{:.1e}", x); }

class Survey {
 public:
  explicit Survey(const Pairs& pairs) : pairs_(pairs) {}
  void add(Answer answer) { answers_.push_back(std::move(answer)); }
  bool solved() const {
    return std::none_of(answers_.begin(), answers_.end(),
                        [](const Answer& a) { return a.verdict == Verdict::error; });
  }
  bool passed() const {
    return std::all_of(answers_.begin(), answers_.end(), [](const Answer& a) {
      return a.verdict == Verdict::ok || a.verdict == Verdict::none;
    });
  }
  const std::vector<Answer>& answers() const { return answers_; }

  /// The table. Random mechanisms appear only if they did not pass, or if `all_rows`; a summary line
  /// describes the others.
  std::string text(std::size_t scenes, bool all_rows) const {
    Table table(columns(pairs_));
    for (std::size_t k = 0; k < answers_.size(); ++k)
      if (k < scenes || all_rows || answers_[k].verdict == Verdict::cancels ||
          answers_[k].verdict == Verdict::exceeds || answers_[k].verdict == Verdict::error)
        table.add(fields(pairs_, answers_[k], short_number));
    ErrorLines errors;
    for (const Answer& a : answers_)
      if (!a.error.empty()) errors.add(a.error);
    std::string out = table.text() + errors.text();
    for (const Answer& a : answers_)
      if (a.verdict == Verdict::cancels)
        out += fmt::format(
            "{}: the terms that determine lambda cancel by a factor of {:.2g}; the difference exceeds the "
            "bound by less than this factor\n",
            a.scene, a.cancellation);
    if (answers_.size() > scenes) out += random_summary(scenes);
    return out;
  }

  std::string json() const {
    JsonWriter json;
    json.begin_object().flag("passed", passed()).begin_array("scenes");
    for (const Answer& a : answers_) {
      json.begin_object().text("scene", a.scene).number("nb", a.nb);
      if (a.analysed) json.number("nc", a.nc).number("rank", a.rank).number("kappa", a.kappa);
      if (!a.difference.empty()) {
        json.begin_object("difference");
        constexpr double none = std::numeric_limits<double>::quiet_NaN();  // written as null
        for (std::size_t k = 0; k < pairs_.size(); ++k)
          json.number(pairs_[k].name, a.comparable() ? a.difference[k] : none);
        json.end_object();
      }
      if (a.analysed) json.number("bound", a.bound).number("cancellation", a.cancellation);
      json.text("verdict", name_of(a.verdict));
      if (!a.error.empty()) json.text("error", a.error);
      json.end_object();
    }
    return json.end_array().end_object().str();
  }

 private:
  std::string random_summary(std::size_t from) const {
    std::vector<double> ratio, difference;
    std::size_t none = 0, errors = 0, cancelling = 0;
    for (std::size_t k = from; k < answers_.size(); ++k) {
      const Answer& a = answers_[k];
      if (a.verdict == Verdict::none) ++none;
      if (a.verdict == Verdict::cancels) ++cancelling;
      if (a.verdict == Verdict::error) ++errors;
      if (!a.comparable()) continue;
      difference.push_back(a.worst());
      ratio.push_back(bound_factor * a.worst() / a.bound);
    }
    std::string out = counted(answers_.size() - from, "random mechanism", "random mechanisms");
    out += fmt::format(" ({} without unique multipliers, {} beyond the bound with the verdict cancels{})",
                       none, cancelling, errors ? fmt::format(", {} not solved", errors) : "");
    if (ratio.empty()) return out + "\n";
    std::sort(ratio.begin(), ratio.end());
    std::sort(difference.begin(), difference.end());
    return out + fmt::format(
                     ": difference {:.1e} median, {:.1e} largest; in units of u kappa {:.2g} median, {:.2g} "
                     "largest (bound {})\n",
                     difference[difference.size() / 2], difference.back(), ratio[ratio.size() / 2],
                     ratio.back(), bound_factor);
  }

  const Pairs pairs_;
  std::vector<Answer> answers_;
};

int run(const ComparedFormulations& formulations, const Program& program, const Arguments& arguments) {
  const Pairs pairs = pairs_of(formulations.names);
  const std::size_t random_count = arguments.random.value_or(program.names_scenes() ? 0 : 200);
  const std::vector<NamedScene> scenes = program.scenes(0);
  Survey survey(pairs);
  Progress progress("lambda_invariance", scenes.size() + random_count);
  for (const NamedScene& named : scenes) {
    survey.add(ask(formulations, pairs, named));
    progress.step();
  }
  for (std::size_t k = 0; k < random_count; ++k) {
    survey.add(ask(formulations, pairs, consistent_random_scene(arguments.seed + k)));
    progress.step();
  }
  ResultsFile file("lambda_invariance", columns(pairs));
  for (const Answer& answer : survey.answers()) file.add(fields(pairs, answer, results_number));
  program.write(file);
  fmt::print("{}", program.json() ? survey.json() : survey.text(scenes.size(), arguments.all_rows));
  return batch_exit(survey.solved(), survey.passed());
}

}  // namespace

int lambda_invariance(int argc, char** argv, const ComparedFormulations& formulations) {
  Program program("Is lambda the same number in every formulation?", "lambda_invariance");
  Arguments arguments;
  program.options()
      .add_option(
          "--random", &arguments.random,
          "Number of random mechanisms in addition to the scenes (default 200, or 0 if scenes are named)")
      .check(whole_number(1'000'000'000));
  program.options()
      .add_option("--seed", &arguments.seed, "Seed of the first random mechanism")
      .check(whole_number(std::numeric_limits<std::uint64_t>::max()))
      .show_default();
  program.options().add_flag("--all", &arguments.all_rows, "Also print a line for every random mechanism");
  return program.run(argc, argv, [&] { return run(formulations, program, arguments); });
}

}  // namespace trivium
