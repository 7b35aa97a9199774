/// Writes the end of a run into a scene. The counted turns of springs need care: the run lists them by the
/// type of the effect, the scene in its own order.

#include "trivium/run_end.hpp"

#include "scenes/scene_state.hpp"

namespace trivium {

namespace {

/// Gives every joint angle of an effect the next number of full turns from the list. RunEnd::turns lists them
/// type by type, and within one type in the order of the scene.
struct TakeTurns : KeyVisitor {
  std::vector<int>::const_iterator& next;
  explicit TakeTurns(std::vector<int>::const_iterator& from) : next(from) {}
  void joint(std::string_view, JointAngle<double>& angle) const { angle.set_turns(*next++); }
};

}  // namespace

void set_end(scenes::Scene& scene, const RunEnd& end) {
  set_state(scene, end.state);
  auto next = end.turns.begin();
  for (std::size_t type = 0; type < std::variant_size_v<scenes::Effect>; ++type)
    for (scenes::Effect& effect : scene.effects)
      if (effect.index() == type) scenes::visit_keys(TakeTurns(next), effect);
  scene.saved = end.run;
}

}  // namespace trivium
