/// Every file in malformed/ contains one mistake. Its message must state what was found, where, and what is
/// accepted.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "scenes/format/scene_file.hpp"
#include "scenes/format/scene_keys.hpp"

namespace trivium::scenes {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(TRIVIUM_TEST_SCENES_DIR) / "malformed";

/// Replaces {constraint types} and {effect types} by the list of all type names.
std::string with_types(std::string text) {
  for (const auto& [word, names] :
       {std::pair<std::string, std::string>{"{constraint types}", list_of(names_of(constraint_shapes()))},
        {"{effect types}", list_of(names_of(effect_shapes()))}})
    if (const std::size_t at = text.find(word); at != std::string::npos) text.replace(at, word.size(), names);
  return text;
}

/// The expected messages: each line `name | text` of messages.txt is a part of the message about that file.
std::map<std::string, std::vector<std::string>> expected_messages() {
  std::map<std::string, std::vector<std::string>> messages;
  std::ifstream file(folder / "messages.txt");
  for (std::string line; std::getline(file, line);) {
    const std::size_t bar = line.find(" | ");
    if (line.starts_with('#') || bar == std::string::npos) continue;
    messages[line.substr(0, bar)].push_back(with_types(line.substr(bar + 3)));
  }
  return messages;
}

std::vector<std::string> malformed_scenes() {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") names.insert(entry.path().stem());
  return {names.begin(), names.end()};
}

class MalformedScene : public testing::TestWithParam<std::string> {};

TEST_P(MalformedScene, IsRefusedWithItsMessage) {
  const auto messages = expected_messages();
  const auto expected = messages.find(GetParam());
  ASSERT_NE(expected, messages.end()) << "messages.txt says nothing about it";
  const fs::path file = folder / (GetParam() + ".json");
  try {
    read_scene_file(file);
    FAIL() << "it was accepted";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(file.string() + ": ")) << message;
    for (const std::string& part : expected->second)
      EXPECT_NE(message.find(part), std::string::npos) << "message:  " << message << "\nexpected: " << part;
    EXPECT_EQ(error.file(), file.string());
    EXPECT_FALSE(error.found().empty());
    EXPECT_FALSE(error.accepted().empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, MalformedScene, testing::ValuesIn(malformed_scenes()),
                         [](const auto& test) { return test.param; });

TEST(MalformedScenes, EveryExpectedMessageHasItsFile) {
  for (const auto& [name, parts] : expected_messages())
    EXPECT_TRUE(fs::exists(folder / (name + ".json"))) << name;
}

}  // namespace
}  // namespace trivium::scenes
