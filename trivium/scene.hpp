#pragma once
/// Scenes, read from files or built in C++. A scene holds bodies, constraints between them and effects
/// (forces, springs, gravity), with the state of the bodies at one time. Keys, types and defaults are those
/// of the scene format, scenes/format/scene.schema.json; scenes built in C++ pass the same checks as files.
/// Only the position of a body, required in a file, has a default here: the global origin.

#include <array>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivium {

/// Components of a vector [3]; units and frame are those of the quantity.
using Components = std::array<double, 3>;

struct Key;
/// Keys and their values, as a list in braces: {{"kind", "cos"}, {"of", 2}}.
using Keys = std::initializer_list<Key>;

/// A value of the scene format: a number, a text, a flag, a list of numbers, or an object of keys and values
/// such as a function of time, {{"kind", "cos"}, {"of", 2}}. Units and frames are those of the key. A number
/// that is not finite, or a value of a wrong type, is an error at the first use of the scene (Scene).
class Value {
 public:
  /// No value: the key is left out, so its default applies.
  Value() = default;
  /// A number.
  Value(double number);
  /// A number.
  Value(int number) : Value(static_cast<double>(number)) {}
  /// True or false.
  Value(bool flag);
  /// A text. Throws an Error of kind input if it is not UTF-8.
  Value(const char* text) : Value(std::string_view(text)) {}
  /// A text. Throws an Error of kind input if it is not UTF-8.
  Value(const std::string& text) : Value(std::string_view(text)) {}
  /// A text. Throws an Error of kind input if it is not UTF-8.
  Value(std::string_view text);
  /// A list of three numbers.
  Value(const Components& vector);
  /// A list of numbers, of any length.
  Value(std::initializer_list<double> numbers);
  /// An object. Keys whose value is empty are left out. Throws an Error of kind input for a key that is not
  /// UTF-8.
  Value(Keys keys);

  /// The value as JSON text; empty if there is no value.
  const std::string& json() const { return json_; }

 private:
  friend Value list(std::initializer_list<Value> values);
  std::string json_;
};

/// A key of the scene format and its value.
struct Key {
  std::string name;  ///< name of the key, such as "acceleration"
  Value value;       ///< its value; if it is empty, the key is left out
};

/// A list whose elements are not all numbers, such as the rows of a matrix or functions of time. Throws no
/// Error; the elements are checked with the scene.
Value list(std::initializer_list<Value> values);

/// A rigid body, whose frame has its origin at the centre of mass. Default: A = identity, velocities 0.
struct Body {
  std::string name;               ///< unique in the scene; not "ground"
  double mass = 0;                ///< [kg]
  Value inertia = {};             ///< diagonal {Jxx, Jyy, Jzz}, or list of 3 rows [kg m^2], body frame
  Value position = {0., 0., 0.};  ///< position of the centre of mass [m], [3], global frame
  /// Body to global, in one of four ways: {{"euler_parameters", {1, 0, 0, 0}}}; {{"euler_angles", {a, b, c}},
  /// {"sequence", "313"}} [rad]; {{"axis_angle", {{"axis", {0, 0, 1}}, {"angle", 0.5}}}} [rad]; {{"matrix",
  /// list({...})}} with the three rows of the rotation matrix A.
  Value orientation = {};
  Value velocity = {};              ///< velocity of the centre of mass [m/s], [3], global frame
  Value angular_velocity = {};      ///< omega_bar [rad/s], [3], body frame
  bool unphysical_inertia = false;  ///< true: accept principal moments that violate the triangle inequality
};

/// One side of a constraint: the name of a body, or "ground", and geometry in the frame of that body. Every
/// type accepts `point`, whose default is the origin of the frame. dp1 needs `vector` on both sides, dp2 on
/// side i. All types except dp1, dp2, d and cd need or accept `axis` and `x`
/// (docs/scene_format.md).
///
/// The joint frame (u, v, z) has z along `axis`, u along the part of `x` normal to z, and v = cross(z, u).
/// The default of `x` is the axis of the body frame that is most nearly normal to z; if there are several,
/// the first one.
struct Side {
  std::string body;   ///< name of the body, or "ground"
  Value point = {};   ///< point of the constraint [m], [3], body frame (of the ground: global frame)
  Value vector = {};  ///< vector a of dp1 and dp2 [-], [3], body frame; used as given, not normalised
  Value axis = {};    ///< direction of the joint axis z [-], [3], body frame; of any length above 0
  Value x = {};       ///< direction that determines u [-], [3], body frame; not parallel to `axis`
};

/// A scene. Copies are cheap: they share their parts until one of them changes.
///
/// Functions that add a part return the scene, for further calls. Parts are checked at the first use of the
/// scene, which throws an Error of kind input that names the wrong part and lists the accepted values. Uses
/// are t(), bodies(), constraints(), write() and all functions that take a scene, such as solve(). A scene
/// that was moved from has no parts: its functions throw an Error of kind input.
class Scene {
 public:
  /// An empty scene. The bodies that are added to it have their positions and velocities at time t [s].
  /// Throws no Error; a time that is not finite is an error at the first use.
  explicit Scene(std::string name, double t = 0);

  /// Adds a body with its state at time t(). Throws an Error of kind input for a name that is not UTF-8.
  Scene& add_body(const Body& body);
  /// Adds a constraint with a name that no other constraint has, between sides `i` and `j`. `type` is a
  /// constraint type of the scene format, such as "revolute"; `more` are its further keys, such as {{"f",
  /// 0.5}}. Throws an Error of kind input for a text that is not UTF-8.
  Scene& add_constraint(std::string_view type, std::string_view name, const Side& i, const Side& j,
                        Keys more = {});
  /// Adds an effect. `type` is an effect type of the scene format, such as "gravity"; `keys` are its keys,
  /// such as {{"acceleration", {0, 0, -9.81}}}. Throws an Error of kind input for a text that is not UTF-8.
  Scene& add_effect(std::string_view type, Keys keys = {});

  /// Sets the rank tolerance [-], 1e-14 to 1e-4: a constraint row follows from the others if less than this
  /// share of its gradient is independent of them (docs/redundant_constraints.md). The default is 1e-8,
  /// which is also the least that motions accept. Files do not have it. Throws an Error of kind input for
  /// another number.
  Scene& set_rank_tolerance(double tolerance);

  /// Time of the state [s]. Throws an Error of kind input if the scene is wrong.
  double t() const;
  /// The names of the bodies, in the order of the scene. Throws as t() does.
  std::vector<std::string> bodies() const;
  /// The names of the constraints of all types, in the order of the scene. Throws as t() does.
  std::vector<std::string> constraints() const;

  /// Writes a file of the scene format. Throws an Error of kind input if the scene is wrong or the file
  /// cannot be written; an existing file is then left as it was.
  void write(const std::filesystem::path& file) const;

  struct Contents;
  /// For the library's own sources only (trivium/scene_contents.hpp).
  const Contents& contents() const;
  /// For the library's own sources only: a scene with these contents.
  explicit Scene(std::shared_ptr<const Contents> contents) : contents_(std::move(contents)) {}

 private:
  struct Parts;
  Parts& parts();
  void require_parts() const;

  // One of the two is set (none after a move). parts_: a scene under construction, parsed at its first use;
  // contents_: a scene that was read or simulated.
  std::shared_ptr<const Parts> parts_;
  std::shared_ptr<const Contents> contents_;
};

/// Reads a scene file, or a scene of the catalogue by name. Its state is taken as the state at time t [s];
/// the default is the time of the saved run that the file holds, else 0. Throws an Error of kind input that
/// names the file, the place in it, the value found and the accepted ones. `header` is meant to be left at
/// its default: from the place of this header an installed catalogue is found.
Scene read_scene(const std::string& path_or_name, std::optional<double> t = {},
                 const std::filesystem::path& header = __FILE__);

/// The names of the scenes that are delivered with the library. Throws an Error of kind input if their folder
/// is not there. `header` is as in read_scene.
std::vector<std::string> catalogue_scenes(const std::filesystem::path& header = __FILE__);

}  // namespace trivium
