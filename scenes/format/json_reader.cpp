#include "scenes/format/json_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trivium::scenes {
namespace {

std::vector<std::string_view> key_names(const Shape& shape, bool required_only) {
  std::vector<std::string_view> names;
  for (const Key& key : shape.keys())
    if (key.required || !required_only) names.push_back(key.name);
  return names;
}

void fail_missing(const Path& at, std::string_view key, const std::vector<std::string_view>& required) {
  fail(at, fmt::format("missing key {}", in_quotes(key)), "an object with " + list_of(required));
}

}  // namespace

void fail_type(const Json& json, const Path& at, std::string accepted) {
  fail(at, "found " + describe(json), std::move(accepted));
}

ObjectReader::ObjectReader(const Json& json, const Path& at, const Shape& shape) : at_(at), shape_(shape) {
  if (!json.object()) fail_type(json, at, "an object with " + list_of(key_names(shape, false)));
  for (const Member& member : *json.object()) {
    const Key* known = shape.find(member.key);
    if (!known) {
      const std::vector<std::string_view> names = key_names(shape, false);
      fail(at / std::string_view(member.key), "unknown key " + in_quotes(member.key), list_of(names),
           nearest(member.key, names));
    }
    const Json*& found = found_[static_cast<std::size_t>(known - shape.keys().data())];
    if (found)
      fail(at / std::string_view(member.key), "repeated key " + in_quotes(member.key), "each key once");
    found = &member.value;
  }
  for (const Key& key : shape.keys())
    if (key.required && !find(key.name)) fail_missing(at, key.name, key_names(shape, true));
}

const Json* ObjectReader::find(std::string_view key) const {
  const Key* known = shape_.find(key);
  return known ? found_[static_cast<std::size_t>(known - shape_.keys().data())] : nullptr;
}

std::size_t read_choice(const Json& json, const Path& at, std::string_view noun,
                        const std::vector<std::string_view>& names) {
  if (!json.text()) fail_type(json, at, fmt::format("a {}: {}", noun, list_of(names)));
  const auto known = std::find(names.begin(), names.end(), *json.text());
  if (known == names.end())
    fail(at, fmt::format("unknown {} {}", noun, in_quotes(*json.text())), list_of(names),
         nearest(*json.text(), names));
  return static_cast<std::size_t>(known - names.begin());
}

std::size_t read_tag(const Json& json, const Path& at, std::string_view tag, std::string_view noun,
                     const std::vector<std::string_view>& names) {
  if (json.object())
    for (const Member& member : *json.object())
      if (member.key == tag) return read_choice(member.value, at / tag, noun, names);
  const std::string accepted =
      fmt::format("an object with the key {}, one of {}", in_quotes(tag), list_of(names));
  if (!json.object()) fail_type(json, at, accepted);
  fail(at, "missing key " + in_quotes(tag), accepted);
}

void read_value(const Json& json, const Path& at, bool& out) {
  const bool* found = std::get_if<bool>(&json.value);
  if (!found) fail_type(json, at, "true or false");
  out = *found;
}

void read_value(const Json& json, const Path& at, double& out) {
  if (!json.number()) fail_type(json, at, "a number");
  out = *json.number();
}

void read_value(const Json& json, const Path& at, std::string& out) {
  if (!json.text()) fail_type(json, at, "a string");
  out = *json.text();
}

const Json::Array& read_items(const Json& json, const Path& at, std::string_view items,
                              std::optional<std::size_t> size) {
  const Json::Array* array = json.array();
  if (!array || (size && array->size() != *size))
    fail_type(json, at,
              size ? fmt::format("an array of {} {}", *size, items) : fmt::format("an array of {}", items));
  return *array;
}

}  // namespace trivium::scenes
