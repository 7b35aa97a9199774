/// Finds the cheapest run of each method that reaches a target error, and prints them as a table.

#include "validation/precision/cost_at_error.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/table.hpp"
#include "results/tools/position_targets.hpp"

namespace trivium::precision {

namespace {

/// The cheapest run that reaches the target error, among the runs whose settings satisfy `counts`; null if
/// there is none.
template <class Counts>
const RunResult* cheapest(const SceneResult& result, double target, const Counts& counts) {
  const RunResult* best = nullptr;
  if (result.reference_error > target / 10) return best;  // the reference is not accurate enough to judge
  for (const RunResult& o : result.runs)
    if (o.solved() && counts(o.settings) && o.errors.position <= target &&
        (best == nullptr || o.seconds.median < best->seconds.median))
      best = &o;
  return best;
}

}  // namespace

std::string who(const RunSettings& e) {
  return e.formulation.empty() ? fmt::format("{} {}", e.engine, e.method)
                               : fmt::format("{}, {}", e.method, e.formulation);
}
bool is_peer(const RunSettings& e) { return e.formulation.empty(); }

std::string cost_table(const SceneResult& result) {
  std::vector<std::string> header{"method"};
  for (const double target : position_targets) header.push_back(fmt::format("{:.0e} m", target));
  Table table(header);
  std::vector<std::string> contenders;
  for (const RunResult& o : result.runs)
    if (std::find(contenders.begin(), contenders.end(), who(o.settings)) == contenders.end())
      contenders.push_back(who(o.settings));
  for (const std::string& contender : contenders) {
    std::vector<std::string> row{contender};
    for (const double target : position_targets) {
      const RunResult* best =
          cheapest(result, target, [&](const RunSettings& e) { return who(e) == contender; });
      row.push_back(best ? fmt::format("{:.2f} ms ({})", 1e3 * best->seconds.median, best->settings.setting())
                         : "-");
    }
    table.add(row);
  }
  std::string out = fmt::format(
      "{}, {} s: CPU time to reach a position error (error of the reference: {}{})\n\n{}", result.scene,
      result.t_end,
      result.reference_error > 0 ? fmt::format("{:.0e} m", result.reference_error)
                                 : "none in double, the two reference solutions agree",
      result.is_trusted ? "; the reference is also compared with trusted numbers" : "", table.text());
  for (const double target : position_targets) {
    const RunResult *ours = cheapest(result, target, [](const RunSettings&e) { return !is_peer(e); }),
                    *peer = cheapest(result, target, is_peer);
    if (ours && peer)
      out += fmt::format("{:.0e} m: Simbody's best ({}) takes {:.2f} x the time of our best ({})\n", target,
                         peer->settings.method, peer->seconds.median / ours->seconds.median,
                         who(ours->settings));
  }
  for (const RunResult& o : result.runs)
    if (!o.solved()) out += fmt::format("{}, {}: {}\n", who(o.settings), o.settings.setting(), o.failure);
  return out + "\n";
}

}  // namespace trivium::precision
