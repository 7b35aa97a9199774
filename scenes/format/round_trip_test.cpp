/// A written scene reads back as the same scene, and is then written as the same text.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "scenes/format/scene_file.hpp"
#include "scenes/testing/arbitrary_scene.hpp"

namespace trivium::scenes {
namespace {

namespace fs = std::filesystem;

/// The catalogue, and the scenes in wellformed/, which use every word of the format.
std::vector<fs::path> scene_files() {
  std::vector<fs::path> files;
  const fs::path catalogue = TRIVIUM_SCENES_DIR;
  for (const fs::path& folder : {catalogue, fs::path(TRIVIUM_TEST_SCENES_DIR) / "wellformed"})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class SceneFile : public testing::TestWithParam<fs::path> {};

TEST_P(SceneFile, IsReadAndRoundTrips) {
  const Scene scene = read_scene_file(GetParam());
  const std::string text = write_scene(scene);
  const Scene again = parse_scene(text, "written");
  EXPECT_EQ(again, scene);
  EXPECT_EQ(write_scene(again), text);
}

INSTANTIATE_TEST_SUITE_P(All, SceneFile, testing::ValuesIn(scene_files()), [](const auto& test) {
  return test.param.parent_path().filename().string() + "_" + test.param.stem().string();
});

RC_GTEST_PROP(ArbitraryScene, RoundTrips, ()) {
  const Scene scene = arbitrary_scene();
  const std::string text = write_scene(scene);
  const Scene again = parse_scene(text, "written");
  RC_ASSERT(again == scene);
  RC_ASSERT(write_scene(again) == text);
}

Scene one_body() {
  Scene scene;
  Body& body = scene.bodies.emplace_back();
  body.name = "a";
  body.mass = 1;
  body.inertia = Vector3{1, 1, 1};
  return scene;
}

TEST(Writer, KeepsEveryBitOfADouble) {
  Scene scene = one_body();
  for (double x : {0.1, 1.0 / 3, -0.0, 5e-324, 1e100, 123456789012345678.0, 0.30000000000000004}) {
    scene.bodies[0].position = {x, x, x};
    const double again = parse_scene(write_scene(scene), "written").bodies[0].position[1];
    EXPECT_EQ(again, x);
    EXPECT_EQ(std::signbit(again), std::signbit(x));
  }
}

TEST(Writer, LeavesOutDefaults) {
  EXPECT_EQ(
      write_scene(one_body()),
      "{\n"
      "  \"trivium\": 1,\n"
      "  \"bodies\": [{\"name\": \"a\", \"mass\": 1, \"inertia\": [1, 1, 1], \"position\": [0, 0, 0]}]\n"
      "}\n");
}

TEST(Writer, KeepsLinesShort) {
  for (const fs::path& file : scene_files()) {
    std::istringstream text(write_scene(read_scene_file(file)));
    for (std::string line; std::getline(text, line);) {
      const bool is_prose = line.starts_with("  \"description\"") || line.starts_with("  \"reference\"");
      EXPECT_TRUE(is_prose || line.size() <= 110) << line;
    }
  }
}

TEST(Writer, RefusesWhatCouldNotBeReadAgain) {
  const auto refuses = [](auto spoil) {
    Scene scene = one_body();
    spoil(scene);
    EXPECT_THROW(write_scene(scene), SceneError);
  };
  const auto force_on = [](int body, TimeFunction f) {
    Force<double> force;
    force.body = body;
    force.components[0] = std::move(f);
    return force;
  };
  refuses([](Scene& s) { s.bodies.clear(); });
  refuses([](Scene& s) { s.bodies[0].mass = std::nan(""); });
  refuses([](Scene& s) { s.bodies[0].velocity[2] = INFINITY; });
  refuses([](Scene& s) { s.bodies[0].inertia = Vector3{1, std::nan(""), 1}; });
  refuses([](Scene& s) { s.bodies[0].name = "\xff"; });
  refuses([](Scene& s) { s.bodies[0].orientation = EulerAngles{{}, {{0, 0, 7}}}; });
  refuses([&](Scene& s) { s.effects.push_back(force_on(1, 0)); });
  refuses([&](Scene& s) { s.effects.push_back(force_on(ground, 0)); });
  refuses([&](Scene& s) { s.effects.push_back(force_on(0, TimeFunction::Sin{})); });
  refuses([&](Scene& s) { s.effects.push_back(force_on(0, TimeFunction::Polynomial{})); });
  refuses([&](Scene& s) {
    TimeFunction deep = 1;
    for (int k = 0; k < 100; ++k) deep = TimeFunction::Sin{{deep}};
    s.effects.push_back(force_on(0, deep));
  });
  refuses([](Scene& s) { s.effects.push_back(TorsionalSpringDamper<double>{}); });
}

TEST(Writer, RefusesWhatItWouldLose) {
  Scene scene = one_body();
  Constraint& joint = scene.constraints.emplace_back();
  joint.name = "c";
  joint.i.body = 0;
  EXPECT_NO_THROW(write_scene(scene));
  joint.f = 1;
  EXPECT_THROW(write_scene(scene), SceneError);
  joint.f = 0;
  joint.i.x = Vector3{1, 0, 0};
  EXPECT_THROW(write_scene(scene), SceneError);
}

class WrittenFile : public testing::Test {
 protected:
  const fs::path folder = fs::temp_directory_path() / ("trivium_" + std::to_string(std::random_device{}()));
  void SetUp() override { fs::create_directory(folder); }
  void TearDown() override { fs::remove_all(folder); }
};

TEST_F(WrittenFile, IsReadAsTheSameScene) {
  write_scene_file(folder / "a.json", one_body());
  EXPECT_EQ(read_scene_file(folder / "a.json"), one_body());
}

TEST_F(WrittenFile, ReplacesTheOldOneWhole) {
  std::ofstream(folder / "a.json") << std::string(10000, ' ');
  write_scene_file(folder / "a.json", one_body());
  EXPECT_EQ(read_scene_file(folder / "a.json"), one_body());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(WrittenFile, IsLeftAloneByARefusedScene) {
  write_scene_file(folder / "a.json", one_body());
  EXPECT_THROW(write_scene_file(folder / "a.json", Scene{}), SceneError);
  EXPECT_EQ(read_scene_file(folder / "a.json"), one_body());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(WrittenFile, FollowsALink) {
  write_scene_file(folder / "a.json", one_body());
  fs::create_symlink("a.json", folder / "link.json");
  Scene heavier = one_body();
  heavier.bodies[0].mass = 2;
  write_scene_file(folder / "link.json", heavier);
  EXPECT_TRUE(fs::is_symlink(folder / "link.json"));
  EXPECT_EQ(read_scene_file(folder / "a.json"), heavier);
}

TEST_F(WrittenFile, IsNeitherAFolderNorInAMissingOne) {
  EXPECT_THROW(write_scene_file(folder, one_body()), SceneError);
  EXPECT_THROW(write_scene_file(folder / "none" / "a.json", one_body()), SceneError);
}

}  // namespace
}  // namespace trivium::scenes
