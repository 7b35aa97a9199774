/// One line for each scene: the differences of lambda along the motion and at single states, and their
/// bounds.

#include "paper/generator/statistics.hpp"
#include "paper/generator/table.hpp"

namespace trivium::paper {

std::string motion_invariance_table(Results& results, Numbers& numbers) {
  const ResultsTable& table = results["motion_invariance"];
  TexTable out({{"l", {"scene"}},
                {"r", {"$t$ [s]"}},
                {"r", {"steps"}},
                {scientific, {"amplified"}},
                {scientific, {"along"}},
                {scientific, {"bound"}},
                {scientific, {"at one state"}},
                {condition, {"$\\kappa$"}},
                {scientific, {"of its bound"}}});
  Sample along, along_ratio, state, state_ratio, amplification;
  std::size_t failed = 0, none = 0;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const std::string& scene = table.text(k, "scene");
    const std::string& verdict = table.text(k, "verdict");
    if (verdict == "none") {
      ++none;
      continue;
    }
    if (verdict != "ok") ++failed;
    out.add({text(scene), text(table.text(k, "t_end")), text(table.text(k, "steps")),
             number_or_text(table.text(k, "amplification")), number_or_text(table.text(k, "lambda")),
             number_or_text(table.text(k, "lambda_bound")), number_or_text(table.text(k, "state_lambda")),
             number_or_text(table.text(k, "state_kappa")), number_or_text(table.text(k, "state_ratio"))});
    if (verdict == "ERROR") continue;
    amplification.add(table.number(k, "amplification"), scene);
    along.add(table.number(k, "lambda"), scene);
    along_ratio.add(table.number(k, "lambda_ratio"), scene);
    state.add(table.number(k, "state_lambda"), scene);
    state_ratio.add(table.number(k, "state_ratio"), scene);
  }
  numbers.define("MotionCount", integer(table.rows.size()));
  numbers.define("MotionCompared", integer(along.size()));
  numbers.define("MotionNone", integer(none));
  numbers.define("MotionFailed", integer(failed));
  numbers.define("MotionAmplificationWorst", in_text(amplification.worst()));
  numbers.define("MotionAmplificationWorstScene", text(amplification.worst_name()));
  numbers.define("MotionAlongMedian", in_text(along.median()));
  numbers.define("MotionAlongWorst", in_text(along.worst()));
  numbers.define("MotionAlongWorstScene", text(along.worst_name()));
  numbers.define("MotionAlongRatioMedian", in_text(along_ratio.median()));
  numbers.define("MotionAlongRatioWorst", in_text(along_ratio.worst()));
  numbers.define("MotionStateMedian", in_text(state.median()));
  numbers.define("MotionStateWorst", in_text(state.worst()));
  numbers.define("MotionStateRatioWorst", in_text(state_ratio.worst()));
  return out.str("results/motion_invariance.csv");
}

}  // namespace trivium::paper
