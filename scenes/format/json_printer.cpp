/// Prints JSON in lines of limited length (declared in json.hpp).

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scenes/format/json.hpp"

namespace trivium::scenes {
namespace {

/// Largest length of a line in characters, as in the sources of the project.
constexpr std::size_t page_width = 110;

class Printer {
 public:
  explicit Printer(const Path& root) : root_(root) {}

  void print(const Json& json, std::size_t indent, std::size_t room) {
    if (indent > 0 && print_on_one_line(json, room)) return;
    if (const Json::Array* array = json.array())
      print_items(*array, '[', ']', indent, [](const Json& item) -> const Json& { return item; });
    else if (const Json::Object* object = json.object())
      print_items(*object, '{', '}', indent, [this](const Member& member) -> const Json& {
        print_string(member.key), text_ += ": ";
        return member.value;
      });
    else
      print_scalar(json);
  }

  std::string take() { return std::move(text_) + '\n'; }

 private:
  template <class Items, class Value>
  void print_items(const Items& items, char left, char right, std::size_t indent, Value value_of) {
    text_ += left;
    for (std::size_t k = 0; k < items.size(); ++k) {
      text_ += '\n';
      const std::size_t line = text_.size();
      text_.append(indent + 2, ' ');
      const Json& value = value_of(items[k]);
      const bool last = k + 1 == items.size();
      const std::size_t used = text_.size() - line + (last ? 0 : 1);
      print(value, indent + 2, used < page_width ? page_width - used : 0);
      if (!last) text_ += ',';
    }
    if (!items.empty()) text_ += '\n', text_.append(indent, ' ');
    text_ += right;
  }

  /// Prints the value if it takes at most `room` characters; otherwise leaves the text unchanged.
  bool print_on_one_line(const Json& json, std::size_t room) {
    const std::size_t start = text_.size();
    const bool fits = compact(json, start + room);
    if (!fits) text_.resize(start);
    return fits;
  }
  bool compact(const Json& json, std::size_t end) {
    if (const Json::Array* array = json.array()) {
      text_ += '[';
      for (std::size_t k = 0; k < array->size(); ++k) {
        if (k) text_ += ", ";
        if (!compact((*array)[k], end)) return false;
      }
      text_ += ']';
    } else if (const Json::Object* object = json.object()) {
      text_ += '{';
      for (std::size_t k = 0; k < object->size(); ++k) {
        if (k) text_ += ", ";
        print_string((*object)[k].key), text_ += ": ";
        if (!compact((*object)[k].value, end)) return false;
      }
      text_ += '}';
    } else {
      print_scalar(json);
    }
    return text_.size() <= end;
  }

  void print_scalar(const Json& json) {
    if (const double* number = json.number())
      text_ += shortest(*number);
    else if (const std::string* string = json.text())
      print_string(*string);
    else if (const bool* b = std::get_if<bool>(&json.value))
      text_ += *b ? "true" : "false";
    else
      text_ += "null";
  }
  void print_string(const std::string& string) {
    try {
      text_ += nlohmann::json(string).dump();
    } catch (const nlohmann::json::type_error&) {
      fail(root_, "the string " + in_quotes(string) + " is not UTF-8", "UTF-8");
    }
  }

  const Path& root_;
  std::string text_;
};

}  // namespace

std::string print_json(const Json& json, const Path& root) {
  Printer printer(root);
  printer.print(json, 0, 0);
  return printer.take();
}

std::string shortest(double number) {
  if (number == 0 && std::signbit(number)) return "-0.0";  // many readers take "-0" for the integer 0
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr};
}

}  // namespace trivium::scenes
