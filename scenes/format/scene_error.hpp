#pragma once
/// The error for a file that is not a valid scene, and the path of the faulty place in the document. A
/// message names the file, the place, what was found and what is accepted.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace trivium::scenes {

/// An error in a scene. The place is a JSON pointer such as `/bodies/0/mass`, empty for the document as a
/// whole. Example of a message: `x.json: /bodies/0/mas: unknown key "mas"; accepted: name, mass, inertia (did
/// you mean "mass"?)`.
class SceneError : public Error {
 public:
  SceneError(std::string file, std::string path, std::string found, std::string accepted,
             std::string suggestion = {});

  const std::string& file() const { return file_; }              ///< path of the file, or source of the scene
  const std::string& path() const { return path_; }              ///< JSON pointer
  const std::string& found() const { return found_; }            ///< what was found, in words
  const std::string& accepted() const { return accepted_; }      ///< what is accepted, in words
  const std::string& suggestion() const { return suggestion_; }  ///< nearest accepted word; may be empty

 private:
  std::string file_, path_, found_, accepted_, suggestion_;
};

/// A place in a document: a chain of keys and indices on the stack. No text is made until an error needs it.
/// A path points to its parent, which must outlive the path. Temporary paths therefore cannot have children
/// (deleted overloads).
class Path {
 public:
  explicit Path(std::string_view file) : key_(file) {}

  Path operator/(std::string_view key) const& { return {this, key, 0}; }
  Path operator/(const char* key) const& { return {this, key, 0}; }
  Path operator/(std::size_t index) const& { return {this, {}, index}; }
  Path operator/(std::string_view) const&& = delete;
  Path operator/(const char*) const&& = delete;
  Path operator/(std::size_t) const&& = delete;

  /// The file at the root of the path.
  std::string file() const;
  std::string pointer() const;  ///< JSON pointer (RFC 6901)
  /// Number of keys and indices.
  int depth() const { return depth_; }

 private:
  Path(const Path* parent, std::string_view key, std::size_t index)
      : parent_(parent), key_(key), index_(index), depth_(parent->depth_ + 1) {}

  const Path* parent_ = nullptr;
  std::string_view key_;
  std::size_t index_ = 0;
  int depth_ = 0;
};

/// Throws the SceneError for the place `at`.
[[noreturn]] void fail(const Path& at, std::string found, std::string accepted, std::string suggestion = {});

/// Text from outside made safe to print: escaped as in JSON, and shortened to `longest` characters.
std::string printable(std::string_view text, std::size_t longest = 60);
/// printable() in quotation marks.
std::string in_quotes(std::string_view text);
/// "a, b, c"; a long list is shortened and ends with its number of words.
std::string list_of(const std::vector<std::string_view>& words);
/// The candidate that is closest to `word` in edit distance, if `word` can be a typing error of it; else
/// empty.
std::string nearest(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace trivium::scenes
