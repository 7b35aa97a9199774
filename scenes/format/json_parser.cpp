/// Parses JSON by events of nlohmann::json, and describes values for messages (declared in json.hpp).

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scenes/format/json.hpp"

namespace trivium::scenes {
namespace {

/// Builds the tree from the events of the parser. Unfinished containers are kept in the vector open_ on the
/// heap, so that neither the depth nor the size of a hostile file can exhaust the stack.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TreeBuilder(const Path& root) : root_(root) {}

  Json take() { return std::move(document_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool b) override { return add(b); }
  // The parser calls this for negative integers only, so n == 0 means "-0": as a double it keeps its sign.
  bool number_integer(number_integer_t n) override { return add(n == 0 ? -0.0 : static_cast<double>(n)); }
  bool number_unsigned(number_unsigned_t n) override { return add(static_cast<double>(n)); }
  bool number_float(number_float_t d, const string_t&) override { return add(d); }
  bool string(string_t& s) override { return add(std::move(s)); }
  bool binary(binary_t&) override { return false; }  // occurs only in binary formats

  bool start_object(std::size_t) override { return open<Json::Object>(); }
  bool start_array(std::size_t) override { return open<Json::Array>(); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& k) override {
    std::get<Json::Object>(open_.back().value).push_back({std::move(k), {}});
    return true;
  }

  bool parse_error(std::size_t, const std::string& token, const nlohmann::detail::exception& e) override {
    constexpr int number_overflow = 406;  // identifier of nlohmann::json::out_of_range for such a number
    if (e.id == number_overflow)
      fail_here(fmt::format("{} is not finite as a double", printable(token)), "a finite number");
    // 240 characters hold the place and the cause, and cut a long token of the file
    std::string_view message = e.what();
    message.remove_prefix(std::min(message.find("line "), message.size()));
    fail(root_, fmt::format("not JSON: {}", printable(message, 240)), "a JSON document");
  }

 private:
  /// The place in the tree for the next value.
  Json& next() {
    if (++count_ > most_values)
      fail_here("too many values", fmt::format("at most {} in a file", most_values));
    if (open_.empty()) return document_;
    if (auto* array = std::get_if<Json::Array>(&open_.back().value)) return array->emplace_back();
    return std::get<Json::Object>(open_.back().value).back().value;
  }
  template <class T>
  bool add(T value) {
    next().value = std::move(value);
    return true;
  }
  template <class Container>
  bool open() {
    if (static_cast<int>(open_.size()) >= deepest_nesting)
      fail_here("nested too deep", fmt::format("at most {} levels of objects and arrays", deepest_nesting));
    open_.emplace_back().value.emplace<Container>();
    return true;
  }
  bool close() {
    Json container = std::move(open_.back());
    open_.pop_back();
    return add(std::move(container.value));
  }

  /// Fails with the path of the value that is being read.
  [[noreturn]] void fail_here(std::string found, std::string accepted) const {
    fail_below(root_, 0, std::move(found), std::move(accepted));
  }
  [[noreturn]] void fail_below(const Path& at, std::size_t level, std::string found,
                               std::string accepted) const {
    if (level == open_.size()) fail(at, std::move(found), std::move(accepted));
    const Json& container = open_[level];
    if (const Json::Array* array = container.array())
      fail_below(at / array->size(), level + 1, std::move(found), std::move(accepted));
    fail_below(at / std::string_view(container.object()->back().key), level + 1, std::move(found),
               std::move(accepted));
  }

  const Path& root_;
  Json document_;
  std::vector<Json> open_;
  std::size_t count_ = 0;
};

}  // namespace

Json parse_json(std::string_view text, const Path& root) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) fail(root, "the file is empty", "a scene");
  if (text.size() > largest_file)
    fail(root, fmt::format("a file of {} bytes or more", largest_file + 1),
         fmt::format("at most {} bytes", largest_file));
  TreeBuilder builder(root);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

std::string describe(const Json& json) {
  if (const double* number = json.number()) return "the number " + shortest(*number);
  if (const std::string* text = json.text()) return "the string " + in_quotes(*text);
  if (const Json::Array* array = json.array()) return fmt::format("an array of {}", array->size());
  if (json.object()) return "an object";
  if (const bool* b = std::get_if<bool>(&json.value)) return *b ? "true" : "false";
  return "null";
}

}  // namespace trivium::scenes
