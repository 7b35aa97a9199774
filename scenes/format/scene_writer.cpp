/// Writes a scene as JSON, without the values that are defaults (declared in scene_file.hpp).

#include <array>
#include <cmath>

#include "scenes/format/function_writer.hpp"
#include "scenes/format/scene_checks.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/format/scene_keys.hpp"

namespace trivium::scenes {
namespace {

using scenes::to_json;  // the overload for functions of time (function_writer.hpp)

template <class T, std::size_t n>
Json to_json(const std::array<T, n>& items);
template <class T>
Json to_json(const std::vector<T>& items);
Json to_json(double number) { return number; }
Json to_json(const trivium::Vector3<double>& v) { return to_json(std::array{v[0], v[1], v[2]}); }
Json to_json(const std::string& text) { return text; }
Json to_json(ComponentFrame frame) { return frame_names[static_cast<std::size_t>(frame)]; }

template <class T, std::size_t n>
Json to_json(const std::array<T, n>& items) {
  Json::Array array;
  for (const T& item : items) array.push_back(to_json(item));
  return array;
}
template <class T>
Json to_json(const std::vector<T>& items) {
  Json::Array array;
  array.reserve(items.size());
  for (const T& item : items) array.push_back(to_json(item));
  return array;
}

struct OrientationWriter {
  Json operator()(const EulerParameters& p) const {
    return object_of(Member{"euler_parameters", to_json(p.e)});
  }
  Json operator()(const EulerAngles& angles) const {
    return object_of(Member{"euler_angles", to_json(angles.angles)},
                     Member{"sequence", angles.sequence.name()});
  }
  Json operator()(const AxisAngle& rotation) const {
    return object_of(Member{
        "axis_angle", object_of(Member{"axis", to_json(rotation.axis)}, Member{"angle", rotation.angle})});
  }
  Json operator()(const RotationMatrix& rotation) const {
    return object_of(Member{"matrix", to_json(rotation.A)});
  }
};

// A default is omitted only if reading gives back the same bits: -0 is not the default 0.
bool is_default(double number) { return number == 0 && !std::signbit(number); }
bool is_default(const Vector3& v) { return is_default(v[0]) && is_default(v[1]) && is_default(v[2]); }
bool is_default(const trivium::Vector3<double>& v) {
  return is_default(v[0]) && is_default(v[1]) && is_default(v[2]);
}
bool is_default(const TimeFunction& f) { return f.is_number() && is_default(std::get<double>(f.kind())); }
bool is_default(const std::array<TimeFunction, 3>& f) {
  return is_default(f[0]) && is_default(f[1]) && is_default(f[2]);
}
bool is_default(const std::string& text) { return text.empty(); }
bool is_default(const std::vector<double>& numbers) { return numbers.empty(); }
bool is_default(ComponentFrame frame) { return frame == ComponentFrame::global; }

class ObjectWriter {
 public:
  explicit ObjectWriter(const Shape& shape) : shape_(shape) {}

  ObjectWriter& set(std::string_view key, Json value) {
    object_.push_back({std::string(key), std::move(value)});
    return *this;
  }
  /// Adds the key, unless the object has no such key, or the key is optional and the value is its default.
  template <class T>
  ObjectWriter& add(std::string_view key, const T& value) {
    const Key* known = shape_.find(key);
    if (known && (known->required || !is_default(value))) set(key, to_json(value));
    return *this;
  }
  ObjectWriter& add(std::string_view key, const std::optional<Vector3>& value) {
    return value ? set(key, to_json(*value)) : *this;
  }
  Json done() { return std::move(object_); }

 private:
  const Shape& shape_;
  Json::Object object_;
};

Json to_json(const Body& body) {
  ObjectWriter object(body_shape);
  object.add("name", body.name).add("mass", body.mass);
  object.set("inertia", std::visit([](const auto& J) { return to_json(J); }, body.inertia));
  if (body.unphysical_inertia) object.set("unphysical_inertia", true);
  object.add("position", body.position);
  const EulerParameters* p = std::get_if<EulerParameters>(&body.orientation);
  const bool identity = p && p->e[0] == 1 && is_default(Vector3{p->e[1], p->e[2], p->e[3]});
  if (!identity) object.set("orientation", std::visit(OrientationWriter{}, body.orientation));
  return object.add("velocity", body.velocity).add("angular_velocity", body.angular_velocity).done();
}

Json to_json(const Side& side, const Shape& shape, const Scene& scene) {
  ObjectWriter object(shape);
  object.add("body", scene.body_name(side.body)).add("vector", side.vector).add("point", side.point);
  return object.add("axis", side.axis).add("x", side.x).done();
}

Json to_json(const Constraint& constraint, const Scene& scene) {
  const ConstraintShape& shape = shape_of(constraint.type);
  ObjectWriter object(shape.shape);
  object.set("type", shape.name()).add("name", constraint.name);
  object.set("i", to_json(constraint.i, *shape.i, scene)).set("j", to_json(constraint.j, *shape.j, scene));
  object.add("direction", constraint.direction).add("f", constraint.f);
  return object.add("distance", constraint.distance).add("angle", constraint.angle).done();
}

/// Key visitor that writes an effect.
struct EffectWriter : ValueVisitor<EffectWriter> {
  const Scene& scene;
  ObjectWriter& object;

  EffectWriter(const Scene& of, ObjectWriter& to) : scene(of), object(to) {}

  void body(std::string_view key, int index) const { object.set(key, scene.body_name(index)); }
  void point(std::string_view key, const BodyPoint<double>& end) const {
    ObjectWriter side(point_side);
    object.set(key, side.add("body", scene.body_name(end.body)).add("point", end.s_bar).done());
  }
  void joint(std::string_view key, const JointAngle<double>& angle) const {
    object.set(key, scene.constraints[static_cast<std::size_t>(angle.joint)].name);
  }
  void turns(std::string_view key, const JointAngle<double>& angle) const {
    if (const int turns = angle.turns_of(angle.tracked); turns != 0)
      object.set(key, static_cast<double>(turns));
  }
  void value(std::string_view key, const auto& value) const { object.add(key, value); }
};

Json to_json(const Effect& effect, const Scene& scene) {
  const Shape& shape = effect_shapes()[effect.index()];
  ObjectWriter object(shape);
  object.set("type", shape.name());
  std::visit([&](const auto& one) { object.add("name", one.name); }, effect);
  visit_keys(EffectWriter(scene, object), effect);
  return object.done();
}

Json to_json(const SavedRun& saved) {
  ObjectWriter object(saved_shape);
  object.add("t", saved.t).add("start", saved.start).add("formulation", saved.formulation);
  object.add("integrator", saved.integrator).add("phi", saved.phi).add("phi_dot", saved.phi_dot);
  if (saved.began_singular) object.set("began_singular", true);
  if (!saved.charts.empty()) object.set("charts", to_json(saved.charts));
  object.add("y", saved.y);
  if (!saved.angles.empty()) object.set("angles", to_json(saved.angles));
  if (!saved.fastest.empty()) object.set("fastest", to_json(saved.fastest));
  if (!saved.memory.empty()) object.set("memory", to_json(saved.memory));
  return object.done();
}

Json to_json(const Scene& scene) {
  ObjectWriter object(scene_shape);
  object.set("trivium", 1.0).add("name", scene.name).add("description", scene.description);
  object.add("reference", scene.reference);
  Json::Array bodies, constraints, effects;
  for (const Body& body : scene.bodies) bodies.push_back(to_json(body));
  for (const Constraint& constraint : scene.constraints) constraints.push_back(to_json(constraint, scene));
  for (const Effect& effect : scene.effects) effects.push_back(to_json(effect, scene));
  object.set("bodies", std::move(bodies));
  if (!constraints.empty()) object.set("constraints", std::move(constraints));
  if (!effects.empty()) object.set("effects", std::move(effects));
  if (scene.saved) object.set("saved", to_json(*scene.saved));
  return object.done();
}

}  // namespace

std::string write_scene(const Scene& scene) {
  const Path root("the scene to write");
  check_scene(scene, root);
  const Json json = to_json(scene);
  check_magnitudes(json, root);
  return print_json(json, root);
}

}  // namespace trivium::scenes
