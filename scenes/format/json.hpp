#pragma once
/// JSON (RFC 8259) as a scene needs it: members in file order with repeated keys still visible, every number
/// a finite double. Limits on size, count and nesting keep a hostile file from taking the machine.

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "scenes/format/scene_error.hpp"

namespace trivium::scenes {

inline constexpr std::size_t largest_file = std::size_t{64} << 20;  ///< bytes
inline constexpr std::size_t most_values = 10'000'000;              ///< of any kind, in one document
inline constexpr int deepest_nesting = 64;                          ///< of objects and arrays

struct Member;
struct Json {
  using Array = std::vector<Json>;
  using Object = std::vector<Member>;
  std::variant<std::nullptr_t, bool, double, std::string, Array, Object> value;

  Json();
  template <class T>
  requires(!std::is_same_v<std::remove_cvref_t<T>, Json>) Json(T&& v);  // NOLINT: a value is a document

  const double* number() const { return std::get_if<double>(&value); }
  const std::string* text() const { return std::get_if<std::string>(&value); }
  const Array* array() const { return std::get_if<Array>(&value); }
  const Object* object() const { return std::get_if<Object>(&value); }
};
struct Member {
  std::string key;
  Json value;
};
inline Json::Json() = default;
template <class T>
requires(!std::is_same_v<std::remove_cvref_t<T>, Json>) Json::Json(T&& v) {
  if constexpr (std::is_convertible_v<T, std::string_view>)
    value = std::string(std::forward<T>(v));
  else
    value = std::forward<T>(v);
}

/// "a number 3", "an array of 2": for messages.
std::string describe(const Json& json);

/// The document in `text`; a SceneError names line and column of what is not JSON.
Json parse_json(std::string_view text, const Path& root);

/// The document as text: what fits stands on one line, numbers are the shortest that read back as the same
/// double. Throws a SceneError if a string is not UTF-8.
std::string print_json(const Json& json, const Path& root);

/// The shortest decimal that reads back as the same double; keeps the sign of -0.
std::string shortest(double number);

}  // namespace trivium::scenes
