#pragma once
/// Scenes and files of the front door's tests. A support of the tests.

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "trivium/scene_contents.hpp"

namespace trivium::test {

/// The file of a scene of the catalogue.
inline std::string path_of(const std::string& name) {
  return std::string(TRIVIUM_SCENES_DIR) + "/" + name + ".json";
}

/// A file of the current test's own: tests run side by side.
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
