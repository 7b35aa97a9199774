#include "validation/hard/rank_jump.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/number_text.hpp"
#include "base/raise.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "scenes/building.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium::hard {

namespace {

using building::joint, building::side;
using scenes::Scene, scenes::Vector3;

/// Whether the door is locked in one formulation by one solver, as the angle grows.
struct Locking {
  std::string formulation, solver;
  int jumps = 0, refusals = 0;
  double free = 0, locked = std::numeric_limits<double>::infinity();  ///< largest and least angle [rad]
  bool was_locked = false;
  std::optional<Row> refusal = {};  ///< the first, or the first that announces nothing

  /// The printed equations may have no solution in double where the rank is about to jump.
  void refuse(Row refused) {
    ++refusals;
    if (!refusal || refused.verdict > refusal->verdict) refusal = std::move(refused);
  }
  void add(double angle, bool is_locked) {
    jumps += is_locked != was_locked;
    was_locked = is_locked;
    if (is_locked)
      lower(locked, angle);
    else
      free = angle;
  }
};

/// A locked door is held at a lever of its width times the angle, a swinging one by forces like its weight.
bool is_locked(const FormulationResult<double>& found) {
  constexpr double weight = 20 * 9.81;  // [N]
  return found.solution.lambda.lpNorm<Eigen::Infinity>() > 100 * weight;
}

}  // namespace

Scene misaligned_door(double angle) {
  Scene scene;
  scene.name = fmt::format("misaligned_door_{:g}", angle);
  scene.bodies = {building::body("door", 20, {6, 8, 2}, {0.45, 0, 1})};
  const Vector3 straight{0, 0, 1}, tilted{std::sin(angle), 0, std::cos(angle)};
  for (const auto& [name, height, axis] : {std::tuple("lower", 0.3, straight), {"upper", 1.7, tilted}})
    scene.constraints.push_back(joint(JointType::revolute, name,
                                      side(scenes::ground, Vector3{0, 0, height}, axis),
                                      side(0, Vector3{-0.45, 0, height - 1}, axis)));
  scene.effects = {Gravity<double>{"", {0, -3, -9.81}}};
  return scene;
}

void judge_rank_jump(Judge& judge, double angles_per_decade) {
  const int count = static_cast<int>(10 * angles_per_decade);
  const SolveOptions options{judge.formulations(), {}};
  std::vector<Locking> all;
  for (const char* solver : {"printed", "structured"})
    for (const std::string& formulation : judge.formulations()) all.push_back({formulation, solver});
  for (int k = 0; k <= count; ++k) {
    const double angle = std::pow(10, -14 + 10.0 * k / count);
    const Scene scene = misaligned_door(angle);
    const auto model = make_model<double>(scene);
    auto one = all.begin();
    for (const auto& answer :
         {side_by_side(model, analyse_rows(model), options), structured_side_by_side(model, options)})
      for (const auto& found : answer.formulations) {
        if (found.error.empty())
          one->add(angle, is_locked(found));
        else
          one->refuse(judge.refused({}, found.error, scene));
        ++one;
      }
  }
  double free = 0, locked = std::numeric_limits<double>::infinity();
  for (const Locking& one : all) {
    raise(free, one.free);
    lower(locked, one.locked);
  }
  for (const Locking& one : all) {
    Row row = judge.row(one.formulation, one.solver, "jumps but one [1]");
    row.value = std::abs(one.jumps - 1) + (one.free >= locked) + (one.locked <= free) +
                (one.refusal && one.refusal->verdict == Verdict::fails);
    row.threshold = 0;
    row.why = fmt::format("locked from {:.3g} rad on", one.locked);
    if (one.refusal)
      row.why += fmt::format("; refuses {}: {}", counted(one.refusals, "angle", "angles"), one.refusal->why);
    judge.add(judge.judged(row));
  }
}

}  // namespace trivium::hard
