#pragma once
/// Scenes from files and scenes built in C++. What is built is what a file of the scene format could hold,
/// with its words and its checks: keys, types and defaults are those of scenes/format/scene.schema.json.

#include <array>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivium {

/// Of a vector.
using Components = std::array<double, 3>;

struct Key;
using Keys = std::initializer_list<Key>;

/// A value of the scene format: a number, a text, yes or no, a list, or keys with values of their own (a
/// function of time, say).
class Value {
 public:
  Value() = default;  ///< none: the key is left out
  Value(double number);
  Value(int number) : Value(static_cast<double>(number)) {}
  Value(bool flag);
  Value(const char* text) : Value(std::string_view(text)) {}
  Value(const std::string& text) : Value(std::string_view(text)) {}
  Value(std::string_view text);
  Value(const Components& vector);
  Value(std::initializer_list<double> numbers);
  Value(Keys keys);

  /// As a file has it; empty for none.
  const std::string& json() const { return json_; }

 private:
  friend Value list(std::initializer_list<Value> values);
  std::string json_;
};

struct Key {
  std::string name;
  Value value;
};

/// A list of values that are not all numbers.
Value list(std::initializer_list<Value> values);

struct Body {
  std::string name;
  double mass = 0;                ///< [kg]
  Value inertia = {};             ///< three principal moments, or three rows [kg m^2], body frame
  Value position = {0., 0., 0.};  ///< of the centre of mass [m], global
  Value orientation = {};         ///< of one key, as {{"euler_parameters", {1, 0, 0, 0}}}; else the identity
  Value velocity = {};            ///< [m/s], global
  Value angular_velocity = {};    ///< omega_bar [rad/s], body frame
  bool unphysical_inertia = false;
};

/// A side of a constraint: a body or "ground", and what the type of constraint asks for, in the body's frame.
struct Side {
  std::string body;
  Value point = {}, vector = {}, axis = {}, x = {};
};

class Scene {
 public:
  /// Without bodies. Its state is that at time t [s].
  explicit Scene(std::string name, double t = 0);

  // What is added is checked when the scene is used: an Error then says which part is wrong and what is
  // accepted.
  Scene& add_body(const Body& body);
  Scene& add_constraint(std::string_view type, std::string_view name, const Side& i, const Side& j,
                        Keys more = {});
  Scene& add_effect(std::string_view type, Keys keys = {});

  /// The time [s] of the state.
  double t() const;
  std::vector<std::string> bodies() const, constraints() const;  ///< names, in order

  /// As a file of the scene format, whole or not at all. Throws an Error.
  void write(const std::filesystem::path& file) const;

  struct Contents;
  /// For the library's own sources (trivium/scene_contents.hpp).
  const Contents& contents() const;
  explicit Scene(std::shared_ptr<const Contents> contents) : contents_(std::move(contents)) {}

 private:
  struct Parts;
  Parts& parts();

  // one of the two: what was built is read as a file would be, when it is first asked for
  std::shared_ptr<const Parts> parts_;
  std::shared_ptr<const Contents> contents_;
};

/// A scene file, or a scene of the catalogue by name, whose state is taken as that at t [s]; by default that
/// of the motion's end if it is one, else 0. Throws an Error that names the file, the place in it, what was
/// found and what is accepted.
Scene read_scene(const std::string& path_or_name, std::optional<double> t = {});

/// The names of the catalogue's scenes.
std::vector<std::string> catalogue_scenes();

}  // namespace trivium
