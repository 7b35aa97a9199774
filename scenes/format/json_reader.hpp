#pragma once
/// Converts JSON values to typed values. Every function throws a SceneError that states what was found and
/// what is accepted.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "scenes/format/json.hpp"
#include "scenes/format/scene_keys.hpp"
#include "scenes/scene.hpp"

namespace trivium::scenes {

/// Throws the SceneError for a value of a wrong kind.
[[noreturn]] void fail_type(const Json& json, const Path& at, std::string accepted);

/// Reads the members of an object. An unknown, repeated or missing key throws a SceneError.
class ObjectReader {
 public:
  ObjectReader(const Json& json, const Path& at, const Shape& shape);

  /// The value of a key; null if the object does not have the key.
  const Json* find(std::string_view key) const;

  /// Reads the value of a key. If the key is absent, `out` stays unchanged.
  template <class T, class... Context>
  void read(std::string_view key, T& out, const Context&... context) const {
    if (const Json* json = find(key)) read_value(*json, at_ / key, out, context...);
  }

 private:
  const Path& at_;
  const Shape& shape_;
  std::array<const Json*, most_keys> found_{};
};

/// The index of the text in `names`. Messages call such a name a `noun`.
std::size_t read_choice(const Json& json, const Path& at, std::string_view noun,
                        const std::vector<std::string_view>& names);

/// The index of the object's member `tag` in `names`.
std::size_t read_tag(const Json& json, const Path& at, std::string_view tag, std::string_view noun,
                     const std::vector<std::string_view>& names);

// read_value: reads the value into `out`, whose type determines the accepted kind
/// Reads true or false.
void read_value(const Json& json, const Path& at, bool& out);
/// Reads a number.
void read_value(const Json& json, const Path& at, double& out);
/// Reads a string.
void read_value(const Json& json, const Path& at, std::string& out);
/// Reads a function of time.
void read_value(const Json& json, const Path& at, TimeFunction& out);

/// The items of the array. If `size` is given, the array must have exactly `size` items.
const Json::Array& read_items(const Json& json, const Path& at, std::string_view items,
                              std::optional<std::size_t> size = {});

/// Reads an array of numbers or of strings.
template <class Item>
requires(std::is_same_v<Item, double> ||
         std::is_same_v<Item, std::string>) void read_value(const Json& json, const Path& at,
                                                            std::vector<Item>& out) {
  const Json::Array& items = read_items(json, at, std::is_same_v<Item, double> ? "numbers" : "texts");
  out.resize(items.size());
  for (std::size_t k = 0; k < items.size(); ++k) read_value(items[k], at / k, out[k]);
}
/// Reads an array of n numbers.
template <std::size_t n>
void read_value(const Json& json, const Path& at, std::array<double, n>& out) {
  const Json::Array& items = read_items(json, at, "numbers", n);
  for (std::size_t k = 0; k < n; ++k) read_value(items[k], at / k, out[k]);
}
/// Reads an array of three rows of three numbers.
inline void read_value(const Json& json, const Path& at, Matrix3& out) {
  const Json::Array& rows = read_items(json, at, "rows of 3 numbers", 3);
  for (std::size_t k = 0; k < 3; ++k) read_value(rows[k], at / k, out[k]);
}
/// Reads an array of three functions of time.
inline void read_value(const Json& json, const Path& at, std::array<TimeFunction, 3>& out) {
  const Json::Array& items = read_items(json, at, "functions of time", 3);
  for (std::size_t k = 0; k < 3; ++k) read_value(items[k], at / k, out[k]);
}
/// Reads an array of three numbers.
inline void read_value(const Json& json, const Path& at, trivium::Vector3<double>& out) {
  Vector3 stated{};
  read_value(json, at, stated);
  out = trivium::Vector3<double>(stated.data());
}
/// Reads an array of three numbers that the scene may leave out.
inline void read_value(const Json& json, const Path& at, std::optional<Vector3>& out) {
  read_value(json, at, out.emplace());
}

}  // namespace trivium::scenes
