#pragma once
/// The words of the scene format: which keys each object takes. Reader, checks and writer go by these tables,
/// and scene.schema.json says the same to editors (a test compares them).

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "base/variants.hpp"
#include "scenes/scene.hpp"

namespace trivium::scenes {

struct Key {
  std::string_view name;
  bool required = false;
};
constexpr Key need(std::string_view name) { return {name, true}; }
constexpr Key may(std::string_view name) { return {name, false}; }

/// The keys of one kind of object, in the order in which they are written.
class Shape {
 public:
  constexpr Shape(std::string_view name, std::initializer_list<Key> keys) : name_(name), size_(keys.size()) {
    std::size_t k = 0;
    for (const Key& key : keys) keys_.at(k++) = key;
  }
  /// Behind those there are. Throws a std::out_of_range where an object has no more room for keys.
  constexpr void add(const Key& key) { keys_.at(size_++) = key; }
  constexpr std::string_view name() const { return name_; }
  constexpr std::span<const Key> keys() const { return {keys_.data(), size_}; }
  constexpr const Key* find(std::string_view key) const {
    for (const Key& known : keys())
      if (known.name == key) return &known;
    return nullptr;
  }

 private:
  std::string_view name_;
  std::array<Key, 8> keys_{};
  std::size_t size_;
};

inline constexpr Shape scene_shape{"scene",
                                   {need("trivium"), may("name"), may("description"), may("reference"),
                                    need("bodies"), may("constraints"), may("effects")}};
inline constexpr Shape body_shape{
    "body",
    {need("name"), need("mass"), need("inertia"), may("unphysical_inertia"), need("position"),
     may("orientation"), may("velocity"), may("angular_velocity")}};
/// One of four ways; `sequence` goes with `euler_angles`.
inline constexpr Shape orientation_shape{
    "orientation",
    {may("euler_parameters"), may("euler_angles"), may("sequence"), may("axis_angle"), may("matrix")}};
inline constexpr Shape axis_angle_shape{"axis_angle", {need("axis"), need("angle")}};

/// In the order of TimeFunction::Kind after the plain number.
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

// Sides. Every side may name a point (of a dp1 it says where reactions are taken), and every side of a joint
// an axis with an x, whether or not a row of the type looks along it.
inline constexpr Shape vector_point_side{"vector_point_side", {need("body"), need("vector"), may("point")}};
inline constexpr Shape point_side{"point_side", {need("body"), may("point")}};
inline constexpr Shape joint_side{"joint_side", {need("body"), may("point"), may("axis"), may("x")}};
inline constexpr Shape axis_side{"axis_side", {need("body"), may("point"), need("axis"), may("x")}};
inline constexpr Shape frame_side{"frame_side", {need("body"), may("point"), need("axis"), need("x")}};

struct ConstraintShape {
  ConstraintType type;
  Shape shape;
  const Shape *i, *j;
};

namespace detail {
constexpr ConstraintShape joint(ConstraintType type, std::string_view name, const Shape& i, const Shape& j) {
  return {type, {name, {need("type"), need("name"), need("i"), need("j")}}, &i, &j};
}
constexpr ConstraintShape joint(ConstraintType type, std::string_view name, const Shape& i, const Shape& j,
                                Key more) {
  return {type, {name, {need("type"), need("name"), need("i"), need("j"), more}}, &i, &j};
}
constexpr ConstraintShape joint(ConstraintType type, std::string_view name, const Shape& i, const Shape& j,
                                Key more, Key last) {
  return {type, {name, {need("type"), need("name"), need("i"), need("j"), more, last}}, &i, &j};
}
}  // namespace detail

/// In the order of ConstraintType.
inline constexpr std::array constraint_shapes{
    detail::joint(ConstraintType::dp1, "dp1", vector_point_side, vector_point_side, may("f")),
    detail::joint(ConstraintType::dp2, "dp2", vector_point_side, point_side, may("f")),
    detail::joint(ConstraintType::d, "d", point_side, point_side, need("f")),
    detail::joint(ConstraintType::cd, "cd", point_side, point_side, need("direction"), may("f")),
    detail::joint(ConstraintType::spherical, "spherical", joint_side, joint_side),
    detail::joint(ConstraintType::universal, "universal", axis_side, axis_side),
    detail::joint(ConstraintType::revolute, "revolute", axis_side, axis_side),
    detail::joint(ConstraintType::cylindrical, "cylindrical", axis_side, axis_side),
    detail::joint(ConstraintType::translational, "translational", frame_side, frame_side),
    detail::joint(ConstraintType::fixed, "fixed", frame_side, frame_side),
    detail::joint(ConstraintType::planar, "planar", axis_side, axis_side),
    detail::joint(ConstraintType::in_line, "in_line", axis_side, joint_side),
    detail::joint(ConstraintType::in_plane, "in_plane", axis_side, joint_side),
    detail::joint(ConstraintType::distance, "distance", joint_side, joint_side, need("distance")),
    detail::joint(ConstraintType::rotation_driver, "rotation_driver", frame_side, frame_side, need("angle")),
};
static_assert([] {
  for (std::size_t k = 0; k < constraint_shapes.size(); ++k)
    if (constraint_shapes[k].type != static_cast<ConstraintType>(k)) return false;
  return constraint_shapes.back().type == ConstraintType::rotation_driver;
}());
constexpr const ConstraintShape& shape_of(ConstraintType type) {
  return constraint_shapes[static_cast<std::size_t>(type)];
}

namespace detail {
/// Lists the keys that an effect shows.
struct KeyList {
  Shape& shape;

  void body(std::string_view key, int) { shape.add(scenes::need(key)); }
  void joint(std::string_view key, int) { shape.add(scenes::need(key)); }
  void need(std::string_view key, const auto&) { shape.add(scenes::need(key)); }
  void may(std::string_view key, const auto&) { shape.add(scenes::may(key)); }
};
}  // namespace detail

/// Of every effect, in the order of the list.
inline const std::vector<Shape>& effect_shapes() {
  static const std::vector<Shape> all = [] {
    std::vector<Shape> shapes;
    for (std::size_t k = 0; k < std::variant_size_v<Effect>; ++k) {
      const Effect effect = emplaced<Effect>(k);
      Shape& shape = shapes.emplace_back(std::visit([](const auto& one) { return one.type; }, effect),
                                         std::initializer_list<Key>{need("type"), may("name")});
      visit_keys(detail::KeyList{shape}, effect);
    }
    return shapes;
  }();
  return all;
}
static_assert(function_shapes.size() + 1 == std::variant_size_v<TimeFunction::Kind>);

inline constexpr std::array<std::string_view, 2> frame_names{"global", "body"};  ///< in the order of Frame

}  // namespace trivium::scenes
