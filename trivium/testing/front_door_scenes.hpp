#pragma once
/// Scenes and files for the tests of the public interface. Only tests include this header.

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "trivium/scene_contents.hpp"

namespace trivium::test {

/// The path of a catalogue scene's file.
inline std::string path_of(const std::string& name) {
  return std::string(TRIVIUM_SCENES_DIR) + "/" + name + ".json";
}

/// A temporary file whose name contains that of the current test, because tests run in parallel.
inline std::filesystem::path temporary(const std::string& name) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(testing::TempDir()) / (std::string(test.name()) + "." + name);
}

inline Scene scene_of(scenes::Scene scene) {
  auto contents = std::make_shared<Scene::Contents>();
  contents->source = scene.name;
  contents->scene = std::move(scene);
  return Scene(std::shared_ptr<const Scene::Contents>(contents));
}

}  // namespace trivium::test
