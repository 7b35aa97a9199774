/// scene.schema.json and the tables of the reader contain the same keys.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "scenes/format/scene_keys.hpp"

namespace trivium::scenes {
namespace {

using nlohmann::json;

json schema() {
  std::ifstream file(TRIVIUM_SCENE_SCHEMA);
  return json::parse(file);
}

std::vector<Shape> shapes() {
  std::vector<Shape> all{body_shape, orientation_shape, axis_angle_shape, joint_side, vector_point_side,
                         point_side, axis_side,         frame_side,       saved_shape};
  all.insert(all.end(), function_shapes.begin(), function_shapes.end());
  for (const ConstraintShape& constraint : constraint_shapes()) all.push_back(constraint.shape);
  all.insert(all.end(), effect_shapes().begin(), effect_shapes().end());
  return all;
}

void expect_same_keys(const json& object, const Shape& shape) {
  std::set<std::string> properties, required, known, needed;
  for (const auto& property : object.at("properties").items()) properties.insert(property.key());
  if (object.contains("required")) required = object.at("required").get<std::set<std::string>>();
  for (const Key& key : shape.keys()) {
    known.emplace(key.name);
    if (key.required) needed.emplace(key.name);
  }
  EXPECT_EQ(properties, known) << shape.name();
  EXPECT_EQ(required, needed) << shape.name();
  EXPECT_EQ(object.at("additionalProperties"), false) << shape.name();
}

std::set<std::string> references(const json& alternatives) {
  std::set<std::string> names;
  for (const json& alternative : alternatives)
    if (alternative.contains("$ref")) names.insert(alternative["$ref"].get<std::string>().substr(14));
  return names;
}

TEST(Schema, HasTheKeysOfTheReader) {
  const json document = schema();
  expect_same_keys(document, scene_shape);
  for (const Shape& shape : shapes()) {
    ASSERT_TRUE(document["definitions"].contains(shape.name())) << shape.name();
    expect_same_keys(document["definitions"][std::string(shape.name())], shape);
  }
}

TEST(Schema, HasNoOtherObjects) {
  std::set<std::string> known;
  for (const Shape& shape : shapes()) known.emplace(shape.name());
  const json document = schema();
  for (const auto& definition : document["definitions"].items())
    EXPECT_EQ(definition.value().contains("properties"), known.contains(definition.key()))
        << definition.key();
}

TEST(Schema, HasTheTypesOfTheReader) {
  const json definitions = schema()["definitions"];
  std::set<std::string> functions{"number"}, constraints, effects;
  for (const Shape& shape : function_shapes) functions.emplace(shape.name());
  for (const ConstraintShape& constraint : constraint_shapes()) constraints.emplace(constraint.name());
  for (const Shape& shape : effect_shapes()) effects.emplace(shape.name());
  EXPECT_EQ(references(definitions["function"]["oneOf"]), functions);
  EXPECT_EQ(references(definitions["constraint"]["oneOf"]), constraints);
  EXPECT_EQ(references(definitions["effect"]["oneOf"]), effects);
  functions.erase("number");  // the only kind that is not an object
  for (const std::string& name : functions) EXPECT_EQ(definitions[name]["properties"]["kind"]["const"], name);
  for (const auto& names : {constraints, effects})
    for (const std::string& name : names) EXPECT_EQ(definitions[name]["properties"]["type"]["const"], name);
}

TEST(Schema, HasTheSidesOfTheReader) {
  const json definitions = schema()["definitions"];
  for (const ConstraintShape& constraint : constraint_shapes()) {
    const json& properties = definitions[std::string(constraint.name())]["properties"];
    EXPECT_EQ(properties["i"]["$ref"], "#/definitions/" + std::string(constraint.i->name()));
    EXPECT_EQ(properties["j"]["$ref"], "#/definitions/" + std::string(constraint.j->name()));
  }
}

TEST(Schema, HasTheNamesOfSequencesAndFrames) {
  const json definitions = schema()["definitions"];
  const auto strings = [](const auto& names) { return std::set<std::string>(names.begin(), names.end()); };
  EXPECT_EQ(definitions["orientation"]["properties"]["sequence"]["enum"].get<std::set<std::string>>(),
            strings(euler_sequence_names));
  for (const Shape& effect : effect_shapes()) {
    if (!effect.find("frame")) continue;
    const json& frame = definitions[std::string(effect.name())]["properties"]["frame"];
    EXPECT_EQ(frame["enum"].get<std::set<std::string>>(), strings(frame_names)) << effect.name();
  }
}

}  // namespace
}  // namespace trivium::scenes
