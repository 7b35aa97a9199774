#pragma once
/// JSON (RFC 8259) as a scene needs it: members keep the order of the file, repeated keys stay visible, and
/// every number is a finite double. Limits on size, count and nesting protect against hostile files, which
/// could otherwise exhaust the memory.

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "scenes/format/scene_error.hpp"

namespace trivium::scenes {

// These limits leave about 670 bytes and 100 values for each body of the largest scene (most_bodies),
// together with its joints and effects. The limit of nesting also bounds the depth of the recursion in the
// readers.
inline constexpr std::size_t largest_file = std::size_t{64} << 20;  ///< size of a file [bytes]
inline constexpr std::size_t most_values = 10'000'000;  ///< number of values of any kind in one document
inline constexpr int deepest_nesting = 64;              ///< levels of objects and arrays

struct Member;
/// A JSON value of any kind, with its parts.
struct Json {
  using Array = std::vector<Json>;
  using Object = std::vector<Member>;
  std::variant<std::nullptr_t, bool, double, std::string, Array, Object> value;

  Json();
  Json(Json&&) = default;
  Json& operator=(Json&&) = default;
  template <class T>
  requires(!std::is_same_v<std::remove_cvref_t<T>, Json>) Json(T&& v);  // NOLINT: a value is a document

  // each returns null if the value is of another kind
  const double* number() const { return std::get_if<double>(&value); }
  const std::string* text() const { return std::get_if<std::string>(&value); }
  const Array* array() const { return std::get_if<Array>(&value); }
  const Object* object() const { return std::get_if<Object>(&value); }
};
/// A member of an object.
struct Member {
  std::string key;
  Json value;
};
/// An object of these members. Documents are moved, never copied, as a list of initial values would do.
template <class... Members>
Json object_of(Members... members) {
  Json::Object object;
  object.reserve(sizeof...(members));
  (object.push_back(std::move(members)), ...);
  return object;
}
inline Json::Json() = default;
template <class T>
requires(!std::is_same_v<std::remove_cvref_t<T>, Json>) Json::Json(T&& v) {
  if constexpr (std::is_convertible_v<T, std::string_view>)
    value = std::string(std::forward<T>(v));
  else
    value = std::forward<T>(v);
}

/// The value in words for messages, such as "the number 3" or "an array of 2".
std::string describe(const Json& json);

/// Parses the text. Throws a SceneError with line and column if the text is not JSON.
Json parse_json(std::string_view text, const Path& root);

/// The document as text. A value that fits into the line stands on one line. Throws a SceneError if a string
/// is not UTF-8.
std::string print_json(const Json& json, const Path& root);

/// The shortest decimal number that reads back as the same double. -0 keeps its sign.
std::string shortest(double number);

}  // namespace trivium::scenes
