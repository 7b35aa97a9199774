#include "scenes/format/scene_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <unordered_map>

#include "base/variants.hpp"
#include "scenes/format/json_reader.hpp"

namespace trivium::scenes {
namespace {

/// Names of one kind, bodies or joints. `index` finds every name. `list` has the names that messages propose;
/// of joints only those with an angle, because only these are accepted where a joint is asked for. A joint
/// without an angle is found here and is refused later (scene_checks.cpp).
struct Names {
  std::string_view noun;
  std::vector<std::string_view> list;
  std::unordered_map<std::string_view, int> index;

  int find(const Json& json, const Path& at) const {
    if (!json.text()) fail_type(json, at, fmt::format("the name of a {}", noun));
    const auto known = index.find(*json.text());
    if (known == index.end())
      fail(at, fmt::format("unknown {} {}", noun, in_quotes(*json.text())),
           list.empty() ? fmt::format("the name of a {}; the scene has none", noun) : list_of(list),
           nearest(*json.text(), list));
    return known->second;
  }
};

Names names_of_bodies(const std::vector<Body>& bodies) {
  Names names{"body", {"ground"}, {{"ground", ground}}};
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    names.list.push_back(bodies[k].name);
    names.index.emplace(bodies[k].name, static_cast<int>(k));
  }
  return names;
}

Names names_of_joints(const std::vector<Constraint>& constraints) {
  Names names{"joint", {}, {}};
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    if (properties_of(constraints[k].type).has_an_angle) names.list.push_back(constraints[k].name);
    names.index.emplace(constraints[k].name, static_cast<int>(k));
  }
  return names;
}

void read_value(const Json& json, const Path& at, EulerSequence& out) {
  const std::vector<std::string_view> names(euler_sequence_names.begin(), euler_sequence_names.end());
  out = *parse_euler_sequence(names[read_choice(json, at, "sequence", names)]);
}

void read_value(const Json& json, const Path& at, AxisAngle& out) {
  const ObjectReader object(json, at, axis_angle_shape);
  object.read("axis", out.axis);
  object.read("angle", out.angle);
}

void read_value(const Json& json, const Path& at, Orientation& out) {
  const std::string accepted =
      "an object with one of euler_parameters, euler_angles (with sequence), axis_angle, matrix";
  if (!json.object()) fail_type(json, at, accepted);
  const ObjectReader object(json, at, orientation_shape);
  std::vector<std::string_view> ways;
  for (const char* way : {"euler_parameters", "euler_angles", "axis_angle", "matrix"})
    if (object.find(way)) ways.push_back(way);
  const Json* sequence = object.find("sequence");
  if (ways.empty() && !sequence) fail(at, "found an empty object", accepted);
  if (ways.size() > 1) fail(at, fmt::format("found {} together", fmt::join(ways, " and ")), accepted);
  if ((sequence != nullptr) != (object.find("euler_angles") != nullptr))
    fail(at, sequence ? "a sequence without euler_angles" : "euler_angles without a sequence", accepted);
  object.read("euler_parameters", out.emplace<EulerParameters>().e);
  if (object.find("euler_angles")) {
    EulerAngles& angles = out.emplace<EulerAngles>();
    object.read("euler_angles", angles.angles);
    read_value(*sequence, at / "sequence", angles.sequence);
  }
  if (const Json* axis_angle = object.find("axis_angle"))
    read_value(*axis_angle, at / "axis_angle", out.emplace<AxisAngle>());
  if (object.find("matrix")) object.read("matrix", out.emplace<RotationMatrix>().A);
}

void read_value(const Json& json, const Path& at, std::variant<Vector3, Matrix3>& out) {
  const Json::Array* items = json.array();
  if (!items || items->size() != 3) fail_type(json, at, "[Jxx, Jyy, Jzz] or a symmetric 3x3 matrix");
  if (items->front().number())
    scenes::read_value(json, at, out.emplace<Vector3>());
  else
    scenes::read_value(json, at, out.emplace<Matrix3>());
}

void read_value(const Json& json, const Path& at, Body& out) {
  const ObjectReader object(json, at, body_shape);
  object.read("name", out.name);
  object.read("mass", out.mass);
  if (const Json* inertia = object.find("inertia")) read_value(*inertia, at / "inertia", out.inertia);
  object.read("unphysical_inertia", out.unphysical_inertia);
  object.read("position", out.position);
  if (const Json* orientation = object.find("orientation"))
    read_value(*orientation, at / "orientation", out.orientation);
  object.read("velocity", out.velocity);
  object.read("angular_velocity", out.angular_velocity);
}

Side read_side(const Json& json, const Path& at, const Shape& shape, const Names& bodies) {
  const ObjectReader object(json, at, shape);
  Side side;
  side.body = bodies.find(*object.find("body"), at / "body");
  object.read("point", side.point);
  object.read("vector", side.vector);
  object.read("axis", side.axis);
  object.read("x", side.x);
  return side;
}

void read_value(const Json& json, const Path& at, Constraint& out, const Names& bodies) {
  const std::size_t type = read_tag(json, at, "type", "constraint type", names_of(constraint_shapes()));
  const ConstraintShape& shape = constraint_shapes()[type];
  const ObjectReader object(json, at, shape.shape);
  out.type = shape.type;
  object.read("name", out.name);
  out.i = read_side(*object.find("i"), at / "i", *shape.i, bodies);
  out.j = read_side(*object.find("j"), at / "j", *shape.j, bodies);
  object.read("f", out.f);
  object.read("direction", out.direction);
  object.read("distance", out.distance);
  object.read("angle", out.angle);
}

/// A safety limit: the angle 2 pi turns then still has a rounding error below 1e-9 rad.
constexpr int most_turns = 1'000'000;

/// Key visitor that reads an effect.
struct EffectReader : ValueVisitor<EffectReader> {
  const ObjectReader& object;
  const Path& at;
  const Names &bodies, &joints;

  EffectReader(const ObjectReader& from, const Path& place, const Names& of_bodies, const Names& of_joints)
      : object(from), at(place), bodies(of_bodies), joints(of_joints) {}

  void body(std::string_view key, int& index) const { index = bodies.find(*object.find(key), at / key); }
  void point(std::string_view key, BodyPoint<double>& end) const {
    const Path place = at / key;
    const ObjectReader side(*object.find(key), place, point_side);
    end.body = bodies.find(*side.find("body"), place / "body");
    side.read("point", end.s_bar);
  }
  void joint(std::string_view key, JointAngle<double>& angle) const {
    angle.joint = joints.find(*object.find(key), at / key);
  }
  void turns(std::string_view key, JointAngle<double>& angle) const {
    const Json* json = object.find(key);
    if (!json) return;
    const double* number = json->number();
    if (!number || *number != std::round(*number) || std::abs(*number) > most_turns)
      fail_type(*json, at / key, fmt::format("a whole number of turns, up to {}", most_turns));
    angle.set_turns(static_cast<int>(*number));
  }
  void value(std::string_view key, auto& value) const { object.read(key, value); }
  void value(std::string_view key, ComponentFrame& frame) const {
    if (const Json* json = object.find(key))
      frame = static_cast<ComponentFrame>(
          read_choice(*json, at / key, key, {frame_names.begin(), frame_names.end()}));
  }
};

void read_value(const Json& json, const Path& at, Effect& out, const Names& bodies, const Names& joints) {
  const std::size_t type = read_tag(json, at, "type", "effect type", names_of(effect_shapes()));
  const ObjectReader object(json, at, effect_shapes()[type]);
  out = emplaced<Effect>(type);
  visit_keys(EffectReader(object, at, bodies, joints), out);
  std::visit([&](auto& effect) { object.read("name", effect.name); }, out);
  if (const Json* name = object.find("name"); name && name->text()->empty())
    fail(at / "name", "an empty name", "a name, or no key \"name\"");
}

void read_value(const Json& json, const Path& at, SavedRun& out) {
  const ObjectReader object(json, at, saved_shape);
  object.read("t", out.t);
  object.read("start", out.start);
  object.read("formulation", out.formulation);
  object.read("integrator", out.integrator);
  object.read("phi", out.phi);
  object.read("phi_dot", out.phi_dot);
  object.read("fastest", out.fastest);
  object.read("memory", out.memory);
  object.read("began_singular", out.began_singular);
  object.read("charts", out.charts);
  object.read("y", out.y);
  object.read("angles", out.angles);
}

template <class Item, class... Context>
void read_list(const ObjectReader& scene, const Path& root, std::string_view key, std::vector<Item>& out,
               const Context&... context) {
  const Json* json = scene.find(key);
  if (!json) return;
  const Path at = root / key;
  const Json::Array& items = read_items(*json, at, key);
  out.resize(items.size());
  for (std::size_t k = 0; k < items.size(); ++k) read_value(items[k], at / k, out[k], context...);
}

}  // namespace

Scene read_scene(const Json& json, const Path& root) {
  const ObjectReader object(json, root, scene_shape);
  double version = 0;
  object.read("trivium", version);
  if (version != 1) fail(root / "trivium", "format version " + shortest(version), "version 1");

  Scene scene;
  object.read("name", scene.name);
  object.read("description", scene.description);
  object.read("reference", scene.reference);
  read_list(object, root, "bodies", scene.bodies);
  const Names bodies = names_of_bodies(scene.bodies);
  read_list(object, root, "constraints", scene.constraints, bodies);
  read_list(object, root, "effects", scene.effects, bodies, names_of_joints(scene.constraints));
  if (const Json* saved = object.find("saved")) read_value(*saved, root / "saved", scene.saved.emplace());
  return scene;
}

}  // namespace trivium::scenes
