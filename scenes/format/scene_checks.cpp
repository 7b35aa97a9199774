#include "scenes/format/scene_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <unordered_set>

namespace trivium::scenes {
namespace {

/// Checks that names are unique, and that they are not empty if `required` (bodies and constraints).
class UniqueNames {
 public:
  explicit UniqueNames(std::string_view noun, bool required) : noun_(noun), required_(required) {}

  void add(const std::string& name, const Path& at) {
    if (name.empty() && !required_) return;
    const std::string accepted = fmt::format("a name that no other {} has", noun_);
    if (name.empty()) fail(at / "name", "an empty name", accepted);
    if (!names_.insert(name).second)
      fail(at / "name", fmt::format("a second {} named {}", noun_, in_quotes(name)), accepted);
  }

 private:
  std::string_view noun_;
  bool required_;
  std::unordered_set<std::string_view> names_;
};

void check_body_index(int body, const Scene& scene, const Path& at) {
  if (body != ground && (body < 0 || static_cast<std::size_t>(body) >= scene.bodies.size()))
    fail(at, fmt::format("body number {}", body), fmt::format("-1 to {}", scene.bodies.size() - 1));
}
void check_side(int body, const Scene& scene, const Path& side) {
  check_body_index(body, scene, side / "body");
}

void check_two_bodies(int i, int j, const Scene& scene, const Path& at) {
  check_side(i, scene, at / "i");
  check_side(j, scene, at / "j");
  if (i == j)
    fail(at, fmt::format("both sides on {}", in_quotes(scene.body_name(i))), "two different bodies");
}

/// Key visitor that checks the indices and functions of an effect. Its numbers need no check here: every sign
/// is allowed, and check_magnitudes limits their size.
class EffectChecks : public ValueVisitor<EffectChecks> {
 public:
  EffectChecks(const Scene& scene, const Path& at) : scene_(scene), at_(at) {}

  void body(std::string_view key, int index) const {
    check_body_index(index, scene_, at_ / key);
    if (index == ground) fail(at_ / key, "a load on the ground, which nothing moves", "a body of the scene");
  }
  void point(std::string_view key, const BodyPoint<double>& end) {
    check_side(end.body, scene_, at_ / key);
    if (other_ != nullptr && other_->body == end.body)
      fail(at_, fmt::format("both sides on {}", in_quotes(scene_.body_name(end.body))),
           "two different bodies");
    other_ = &end;
  }
  void joint(std::string_view key, const JointAngle<double>& angle) const {
    if (angle.joint < 0 || static_cast<std::size_t>(angle.joint) >= scene_.constraints.size())
      fail(at_ / key, fmt::format("constraint number {}", angle.joint), "the number of a joint of the scene");
    const Constraint& joint = scene_.constraints[static_cast<std::size_t>(angle.joint)];
    if (!properties_of(joint.type).has_an_angle)
      fail(at_ / key, fmt::format("{}, which has no angle", in_quotes(joint.name)),
           "a revolute or cylindrical joint");
  }
  void value(std::string_view, const auto&) const {}
  void value(std::string_view key, const TimeFunction& f) const { check_function(f, at_ / key); }
  void value(std::string_view key, const std::array<TimeFunction, 3>& functions) const {
    const Path at = at_ / key;
    for (std::size_t k = 0; k < 3; ++k) check_function(functions[k], at / k);
  }

 private:
  const Scene& scene_;
  const Path& at_;
  const BodyPoint<double>* other_ = nullptr;  ///< the first point of an effect between two bodies
};

}  // namespace

void check_magnitudes(const Json& json, const Path& at) {
  if (const double* number = json.number()) {
    if (!(std::abs(*number) <= largest_magnitude))
      fail(at, "found " + shortest(*number), fmt::format("magnitudes up to {}", shortest(largest_magnitude)));
  } else if (const Json::Array* array = json.array()) {
    for (std::size_t k = 0; k < array->size(); ++k) check_magnitudes((*array)[k], at / k);
  } else if (const Json::Object* object = json.object()) {
    for (const Member& member : *object) check_magnitudes(member.value, at / std::string_view(member.key));
  }
}

double norm(const Vector3& v) { return std::hypot(v[0], v[1], v[2]); }

void check_scene(const Scene& scene, const Path& root) {
  const Path bodies = root / "bodies", constraints = root / "constraints", effects = root / "effects";
  if (scene.bodies.empty()) fail(bodies, "no body", "at least one body");
  if (scene.bodies.size() > most_bodies)
    fail(bodies, fmt::format("{} bodies", scene.bodies.size()), fmt::format("at most {}", most_bodies));
  UniqueNames body_names("body", true), constraint_names("constraint", true), effect_names("effect", false);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Path at = bodies / k;
    if (scene.bodies[k].name == "ground")
      fail(at / "name", "a body named \"ground\"", "any other name: ground is implicit");
    body_names.add(scene.bodies[k].name, at);
    check_body(scene.bodies[k], at);
  }
  for (std::size_t k = 0; k < scene.constraints.size(); ++k) {
    const Path at = constraints / k;
    const Constraint& constraint = scene.constraints[k];
    constraint_names.add(constraint.name, at);
    check_two_bodies(constraint.i.body, constraint.j.body, scene, at);
    check_constraint(constraint, at);
  }
  for (std::size_t k = 0; k < scene.effects.size(); ++k) {
    const Path at = effects / k;
    std::visit([&](const auto& effect) { effect_names.add(effect.name, at); }, scene.effects[k]);
    visit_keys(EffectChecks(scene, at), scene.effects[k]);
  }
  const Path saved = root / "saved";
  if (const std::size_t charts = scene.saved ? scene.saved->charts.size() : 0;
      charts != 0 && charts != scene.bodies.size())
    fail(saved / "charts", fmt::format("{} charts", charts),
         fmt::format("one for each of the {} bodies, or none", scene.bodies.size()));
}

}  // namespace trivium::scenes
