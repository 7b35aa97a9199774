#pragma once
/// The vocabulary of the scene format: the keys of each kind of object. Reader, checks and writer use these
/// tables. scene.schema.json states the same keys for editors (schema_test.cpp compares the two).

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/variants.hpp"
#include "scenes/scene.hpp"

namespace trivium::scenes {

/// A key of an object and whether the object must have it.
struct Key {
  std::string_view name;
  bool required = false;
};
/// A key that the object must have.
constexpr Key need(std::string_view name) { return {name, true}; }
inline constexpr std::size_t most_keys = 16;  ///< largest number of keys of one object
/// A key that the object may have.
constexpr Key may(std::string_view name) { return {name, false}; }

/// The keys of one kind of object, in the order in which they are written.
class Shape {
 public:
  constexpr Shape(std::string_view name, std::initializer_list<Key> keys) : name_(name), size_(keys.size()) {
    std::size_t k = 0;
    for (const Key& key : keys) keys_.at(k++) = key;
  }
  /// Appends a key. Throws std::out_of_range if the shape has most_keys keys already.
  constexpr void add(const Key& key) { keys_.at(size_++) = key; }
  constexpr std::string_view name() const { return name_; }
  constexpr std::span<const Key> keys() const { return {keys_.data(), size_}; }
  /// The key with this name; null if the shape does not have the key.
  constexpr const Key* find(std::string_view key) const {
    for (const Key& known : keys())
      if (known.name == key) return &known;
    return nullptr;
  }

 private:
  std::string_view name_;
  std::array<Key, most_keys> keys_{};
  std::size_t size_;
};

/// A scene file.
inline constexpr Shape scene_shape{"scene",
                                   {need("trivium"), may("name"), may("description"), may("reference"),
                                    need("bodies"), may("constraints"), may("effects"), may("saved")}};
/// The end of a run, from which another run continues.
inline constexpr Shape saved_shape{
    "saved",
    {need("t"), need("start"), need("formulation"), need("integrator"), need("phi"), need("phi_dot"),
     may("began_singular"), may("charts"), need("y"), may("angles"), may("fastest"), may("memory")}};
/// A body.
inline constexpr Shape body_shape{
    "body",
    {need("name"), need("mass"), need("inertia"), may("unphysical_inertia"), need("position"),
     may("orientation"), may("velocity"), may("angular_velocity")}};
/// An orientation has exactly one of four forms; `sequence` belongs to `euler_angles`.
inline constexpr Shape orientation_shape{
    "orientation",
    {may("euler_parameters"), may("euler_angles"), may("sequence"), may("axis_angle"), may("matrix")}};
/// The value of `axis_angle` in an orientation.
inline constexpr Shape axis_angle_shape{"axis_angle", {need("axis"), need("angle")}};

/// In the order of TimeFunction::Kind, whose first alternative, the plain number, has no shape.
inline constexpr std::array function_shapes{
    Shape{"polynomial", {need("kind"), need("coefficients")}},
    Shape{"harmonic",
          {need("kind"), need("offset"), need("amplitude"), need("angular_frequency"), need("phase")}},
    Shape{"sin", {need("kind"), need("of")}},
    Shape{"cos", {need("kind"), need("of")}},
    Shape{"sum", {need("kind"), need("terms")}},
    Shape{"product", {need("kind"), need("factors")}},
    Shape{"step5", {need("kind"), need("t0"), need("f0"), need("t1"), need("f1")}},
    Shape{"piecewise", {need("kind"), need("times"), need("pieces")}},
};

// Sides. Every side may have a point (for a dp1 the point where reactions are taken). Every side of a joint
// may have an axis with an x, even if no row of the joint type uses it.

/// A side of a basic constraint that has a vector.
inline constexpr Shape vector_point_side{"vector_point_side", {need("body"), need("vector"), may("point")}};
/// A side of a basic constraint without a vector.
inline constexpr Shape point_side{"point_side", {need("body"), may("point")}};
/// A side of a joint that needs no axis.
inline constexpr Shape joint_side{"joint_side", {need("body"), may("point"), may("axis"), may("x")}};
/// A side of a joint that needs an axis.
inline constexpr Shape axis_side{"axis_side", {need("body"), may("point"), need("axis"), may("x")}};
/// A side of a joint that needs an axis and an x.
inline constexpr Shape frame_side{"frame_side", {need("body"), may("point"), need("axis"), need("x")}};

/// The keys of a constraint type and of its two sides.
struct ConstraintShape {
  ConstraintType type;
  Shape shape;
  const Shape *i, *j;
  bool needs_positive_f = false;  ///< f must be positive (basic_constraint.hpp)

  std::string_view name() const { return shape.name(); }
};

namespace detail {
/// Key visitor that lists the keys of a basic constraint.
struct ConstraintKeyList {
  ConstraintShape& out;
  bool has_point_i = false, has_point_j = false;  // a side has at most one point

  void vector_i(auto&) { take_vector(out.i); }
  void vector_j(auto&) { take_vector(out.j); }
  void point_i(auto&) { take_once(has_point_i); }
  void point_j(auto&) { take_once(has_point_j); }
  void need(std::string_view key, auto& value) { add(scenes::need(key), value); }
  void may(std::string_view key, auto& value) { add(scenes::may(key), value); }

 private:
  static void take_vector(const Shape*& side) {
    bool is_taken = side == &vector_point_side;
    take_once(is_taken);
    side = &vector_point_side;
  }
  static void take_once(bool& is_taken) {
    if (std::exchange(is_taken, true))
      throw std::logic_error("a side in a scene file has one vector and one point");
  }
  void add(const Key& key, const TimeFunction&) { add(key, "f"); }
  void add(const Key& key, const trivium::Vector3<double>&) {
    if (!key.required) throw std::logic_error("a direction has no default");
    add(key, "direction");
  }
  void add(const Key& key, std::string_view member) {
    if (out.shape.find(key.name)) throw std::logic_error("one key twice: " + std::string(key.name));
    if (key.name != member)
      throw std::logic_error("no member of scenes::Constraint for the key " + std::string(key.name));
    out.shape.add(key);
  }
};

/// Key visitor that lists the keys of an effect.
struct EffectKeyList {
  Shape& shape;

  void body(std::string_view key, auto&) const { shape.add(scenes::need(key)); }
  void point(std::string_view key, auto&) const { shape.add(scenes::need(key)); }
  void joint(std::string_view key, auto&) const { shape.add(scenes::need(key)); }
  void need(std::string_view key, auto&) const { shape.add(scenes::need(key)); }
  void may(std::string_view key, auto&) const { shape.add(scenes::may(key)); }
  void place(std::string_view key, auto&) const { shape.add(scenes::may(key)); }
  void angle(std::string_view key, auto&) const { shape.add(scenes::may(key)); }
  void turns(std::string_view key, auto&) const { shape.add(scenes::may(key)); }
};

/// The shape of a joint type. Empty for JointType::basic and for a value after the last type.
inline std::optional<ConstraintShape> joint_shape(JointType type) {
  const auto joint = [&](std::string_view name, const Shape& i, const Shape& j,
                         std::initializer_list<Key> more = {}) {
    ConstraintShape shape{type, {name, {need("type"), need("name"), need("i"), need("j")}}, &i, &j};
    for (const Key& key : more) shape.shape.add(key);
    return shape;
  };
  switch (type) {
    case JointType::basic:
      break;  // see append_basic_shapes
    case JointType::spherical:
      return joint("spherical", joint_side, joint_side);
    case JointType::universal:
      return joint("universal", axis_side, axis_side);
    case JointType::revolute:
      return joint("revolute", axis_side, axis_side);
    case JointType::cylindrical:
      return joint("cylindrical", axis_side, axis_side);
    case JointType::translational:
      return joint("translational", frame_side, frame_side);
    case JointType::fixed:
      return joint("fixed", frame_side, frame_side);
    case JointType::planar:
      return joint("planar", axis_side, axis_side);
    case JointType::in_line:
      return joint("in_line", axis_side, joint_side);
    case JointType::in_plane:
      return joint("in_plane", axis_side, joint_side);
    case JointType::distance:
      return joint("distance", joint_side, joint_side, {need("distance")});
    case JointType::rotation_driver:
      return joint("rotation_driver", frame_side, frame_side, {need("angle")});
  }
  return {};
}

/// Appends the shapes of those basic constraints that have a name in scene files.
inline void append_basic_shapes(std::vector<ConstraintShape>& shapes) {
  using Any = BasicConstraint<double>;
  for (int place = 0; place < static_cast<int>(std::variant_size_v<Any>); ++place) {
    const auto append = [&]<class One>(const One& one) {
      if constexpr (requires { One::type; }) {
        const Shape shape{One::type, {need("type"), need("name"), need("i"), need("j")}};
        shapes.push_back({{JointType::basic, place}, shape, &point_side, &point_side});
        One::keys(ConstraintKeyList{shapes.back()}, one);
        shapes.back().needs_positive_f = requires { requires One::needs_positive_f; };
      }
    };
    std::visit(append, emplaced<Any>(place));
  }
}
}  // namespace detail

/// The shapes of all constraint types that have a name in scene files: basic constraints first, then joints.
inline const std::vector<ConstraintShape>& constraint_shapes() {
  static const std::vector<ConstraintShape> all = [] {
    std::vector<ConstraintShape> shapes;
    detail::append_basic_shapes(shapes);
    for (int k = static_cast<int>(JointType::basic) + 1;; ++k) {
      const auto joint = detail::joint_shape(static_cast<JointType>(k));
      if (!joint) return shapes;
      shapes.push_back(*joint);
    }
  }();
  return all;
}
/// The shape of a constraint type. Throws std::logic_error if the type has no name in scene files.
inline const ConstraintShape& shape_of(ConstraintType type) {
  for (const ConstraintShape& known : constraint_shapes())
    if (known.type == type) return known;
  throw std::logic_error("a type of constraint that scene files have no name for");
}

/// The shapes of all effects, in the order of the variant Effect.
inline const std::vector<Shape>& effect_shapes() {
  static const std::vector<Shape> all = [] {
    std::vector<Shape> shapes;
    for (std::size_t k = 0; k < std::variant_size_v<Effect>; ++k) {
      const Effect effect = emplaced<Effect>(k);
      Shape& shape = shapes.emplace_back(std::visit([](const auto& one) { return one.type; }, effect),
                                         std::initializer_list<Key>{need("type"), may("name")});
      visit_keys(detail::EffectKeyList{shape}, effect);
    }
    return shapes;
  }();
  return all;
}
static_assert(function_shapes.size() + 1 == std::variant_size_v<TimeFunction::Kind>);

/// The names of all shapes in one of the tables above.
template <class Shapes>
std::vector<std::string_view> names_of(const Shapes& shapes) {
  std::vector<std::string_view> names;
  for (const auto& shape : shapes) names.push_back(shape.name());
  return names;
}

/// In the order of ComponentFrame.
inline constexpr std::array<std::string_view, 2> frame_names{"global", "body"};

}  // namespace trivium::scenes
