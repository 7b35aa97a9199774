/// The reader's results: meanings of keys, defaults, suggestions, limits.

#include "scenes/format/scene_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

namespace trivium::scenes {
namespace {

Scene with_body(std::string_view more) {
  return parse_scene(
      fmt::format(
          R"({{"trivium": 1, "bodies": [{{"name": "a", "mass": 2, "inertia": [1, 1, 1], "position": [1, 2, 3]{}}}]}})",
          more),
      "test");
}

Scene with_two_bodies(std::string_view constraints, std::string_view effects = "") {
  constexpr std::string_view body =
      R"({{"name": "{}", "mass": 1, "inertia": [1, 1, 1], "position": [0, 0, 0]}})";
  return parse_scene(
      fmt::format(R"({{"trivium": 1, "bodies": [{}, {}], "constraints": [{}], "effects": [{}]}})",
                  fmt::format(fmt::runtime(body), "a"), fmt::format(fmt::runtime(body), "b"), constraints,
                  effects),
      "test");
}

/// Reads a body with the inertia in `text`, which may contain further keys of the body.
std::variant<Vector3, Matrix3> with_inertia(std::string_view text) {
  return parse_scene(
             fmt::format(
                 R"({{"trivium": 1, "bodies": [{{"name": "a", "mass": 1, "position": [0, 0, 0], "inertia": {}}}]}})",
                 text),
             "test")
      .bodies.at(0)
      .inertia;
}

TimeFunction function(std::string_view text) {
  const Scene scene =
      with_two_bodies("", fmt::format(R"({{"type": "force", "body": "a", "force": [{}, 0, 0]}})", text));
  return std::get<Force<double>>(scene.effects.at(0)).components[0];
}

SceneError error_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const SceneError& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {"", "", "", ""};
}

TEST(Reader, GivesABodyItsDefaults) {
  const Body body = with_body("").bodies.at(0);
  EXPECT_EQ(body.name, "a");
  EXPECT_EQ(body.mass, 2);
  EXPECT_EQ(body.position, (Vector3{1, 2, 3}));
  EXPECT_EQ(body.orientation, Orientation(EulerParameters{{1, 0, 0, 0}}));
  EXPECT_EQ(body.velocity, Vector3{});
  EXPECT_EQ(body.angular_velocity, Vector3{});
  EXPECT_FALSE(body.unphysical_inertia);
}

TEST(Reader, GivesASceneWithoutListsNone) {
  EXPECT_TRUE(with_body("").constraints.empty());
  EXPECT_TRUE(with_body("").effects.empty());
}

TEST(Reader, TakesFourWaysToStateAnOrientation) {
  const auto orientation = [](std::string_view text) {
    return with_body(fmt::format(R"(, "orientation": {})", text)).bodies.at(0).orientation;
  };
  EXPECT_EQ(orientation(R"({"euler_parameters": [2, 0, 0, 1]})"), Orientation(EulerParameters{{2, 0, 0, 1}}));
  EXPECT_EQ(orientation(R"({"axis_angle": {"axis": [0, 3, 0], "angle": 0.5}})"),
            Orientation(AxisAngle{{0, 3, 0}, 0.5}));
  EXPECT_EQ(orientation(R"({"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]})"),
            Orientation(RotationMatrix{{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}}));
  for (std::string_view name : euler_sequence_names)
    EXPECT_EQ(orientation(fmt::format(R"({{"euler_angles": [1, 2, 3], "sequence": "{}"}})", name)),
              Orientation(EulerAngles{{1, 2, 3}, *parse_euler_sequence(name)}));
}

TEST(Reader, TakesInertiaAsMomentsOrMatrixAsGiven) {
  EXPECT_EQ(std::get<Vector3>(with_inertia("[1, 2, 3]")), (Vector3{1, 2, 3}));
  EXPECT_EQ(std::get<Matrix3>(with_inertia("[[2, 1e-13, 0], [0, 2, 0], [0, 0, 2]]")),
            (Matrix3{{{2, 1e-13, 0}, {0, 2, 0}, {0, 0, 2}}}));
  EXPECT_EQ(std::get<Vector3>(with_inertia(R"([4, 2, 0], "unphysical_inertia": true)")), (Vector3{4, 2, 0}));
}

TEST(Reader, TakesAMomentBelowZeroByAsMuchInBothForms) {
  EXPECT_NO_THROW(with_inertia("[1, 1, -1e-12]"));
  EXPECT_NO_THROW(with_inertia("[[1, 0, 0], [0, 1, 0], [0, 0, -1e-12]]"));
  EXPECT_THROW(with_inertia("[1, 1, -4e-12]"), SceneError);
  EXPECT_THROW(with_inertia("[[1, 0, 0], [0, 1, 0], [0, 0, -4e-12]]"), SceneError);
}

TEST(Reader, TakesEveryKindOfFunction) {
  using F = TimeFunction;
  EXPECT_EQ(function("-2.5"), F(-2.5));
  EXPECT_EQ(function(R"({"kind": "polynomial", "coefficients": [1, 2]})"), F(F::Polynomial{{1, 2}}));
  EXPECT_EQ(
      function(R"({"kind": "harmonic", "offset": 1, "amplitude": 2, "angular_frequency": 3, "phase": 4})"),
      F(F::Harmonic{1, 2, 3, 4}));
  EXPECT_EQ(function(R"({"kind": "sin", "of": 1})"), F(F::Sin{{F(1)}}));
  EXPECT_EQ(function(R"({"kind": "cos", "of": {"kind": "sin", "of": 1}})"), F(F::Cos{{F(F::Sin{{F(1)}})}}));
  EXPECT_EQ(function(R"({"kind": "sum", "terms": [1, 2]})"), F(F::Sum{{F(1), F(2)}}));
  EXPECT_EQ(function(R"({"kind": "product", "factors": [1, 2]})"), F(F::Product{{F(1), F(2)}}));
  EXPECT_EQ(function(R"({"kind": "step5", "t0": 1, "f0": 2, "t1": 3, "f1": 4})"), F(F::Step5{1, 2, 3, 4}));
  EXPECT_EQ(function(R"({"kind": "piecewise", "times": [1], "pieces": [2, {"kind": "sin", "of": 3}]})"),
            F(F::Piecewise{{1}, {F(2), F(F::Sin{{F(3)}})}}));
}

TEST(Reader, ResolvesNamesToIndices) {
  const Scene scene = with_two_bodies(
      R"({"type": "revolute", "name": "h", "i": {"body": "ground", "axis": [0, 0, 1]}, "j": {"body": "b", "axis": [0, 0, 1]}})",
      R"({"type": "torsional_spring_damper", "joint": "h"}, {"type": "force", "body": "b", "force": [0, 0, 0]})");
  EXPECT_EQ(scene.constraints.at(0).i.body, ground);
  EXPECT_EQ(scene.constraints.at(0).j.body, 1);
  EXPECT_EQ(std::get<TorsionalSpringDamper<double>>(scene.effects.at(0)).angle.joint, 0);
  EXPECT_EQ(std::get<Force<double>>(scene.effects.at(1)).body, 1);
}

/// Users copy the sides of the revolute as they are. The point has no meaning for the driver's row and is
/// accepted.
TEST(Reader, TakesForADriverTheSidesOfItsRevolute) {
  constexpr std::string_view sides =
      R"("i": {"body": "a", "point": [0, 0, 1], "axis": [0, 0, 1], "x": [1, 0, 0]}, "j": {"body": "b", "point": [0, 0, 2], "axis": [0, 0, 1], "x": [1, 0, 0]})";
  const Scene scene =
      with_two_bodies(fmt::format(R"({{"type": "revolute", "name": "hinge", {0}}}, )"
                                  R"({{"type": "rotation_driver", "name": "driver", {0}, "angle": 0}})",
                                  sides));
  EXPECT_EQ(scene.constraints.at(1).i, scene.constraints.at(0).i);
  EXPECT_EQ(scene.constraints.at(1).j, scene.constraints.at(0).j);
}

TEST(Reader, TakesKeysInAnyOrder) {
  EXPECT_EQ(
      parse_scene(
          R"({"bodies": [{"position": [1, 2, 3], "inertia": [1, 1, 1], "mass": 2, "name": "a"}], "trivium": 1})",
          "test"),
      with_body(""));
}

TEST(Reader, TakesAByteOrderMark) {
  EXPECT_EQ(
      parse_scene(
          "\xef\xbb\xbf"
          R"({"trivium": 1, "bodies": [{"name": "a", "mass": 2, "inertia": [1, 1, 1], "position": [1, 2, 3]}]})",
          "test"),
      with_body(""));
}

TEST(Reader, AllowsNegativeStiffnessAndDamping) {
  const Scene scene = with_two_bodies(
      "",
      R"({"type": "spring_damper", "i": {"body": "a"}, "j": {"body": "b"}, "stiffness": -1, "damping": -2})");
  EXPECT_EQ(std::get<SpringDamper<double>>(scene.effects.at(0)).stiffness, -1);
  EXPECT_EQ(std::get<SpringDamper<double>>(scene.effects.at(0)).damping, -2);
}

TEST(Reader, AllowsASquaredDistanceThatStartsAtZero) {
  EXPECT_NO_THROW(with_two_bodies(
      R"({"type": "d", "name": "c", "i": {"body": "a"}, "j": {"body": "b"}, "f": {"kind": "polynomial", "coefficients": [0, 1]}})"));
}

TEST(SceneError, NamesFilePlaceFindingAndChoice) {
  const SceneError error = error_of([] { with_body(R"(, "velocty": [0, 0, 0])"); });
  EXPECT_EQ(error.file(), "test");
  EXPECT_EQ(error.path(), "/bodies/0/velocty");
  EXPECT_EQ(error.found(), "unknown key \"velocty\"");
  EXPECT_EQ(error.suggestion(), "velocity");
  EXPECT_STREQ(
      error.what(),
      "test: /bodies/0/velocty: unknown key \"velocty\"; accepted: name, mass, inertia, unphysical_inertia, "
      "position, orientation, velocity, angular_velocity (did you mean \"velocity\"?)");
}

TEST(Suggestion, IsTheWordOneSlipAway) {
  const std::vector<std::string_view> words{"gravity", "force", "torque", "spring_damper"};
  EXPECT_EQ(nearest("gravty", words), "gravity");  // a letter is missing
  EXPECT_EQ(nearest("forrce", words), "force");    // a letter is added
  EXPECT_EQ(nearest("torqve", words), "torque");   // a letter is replaced
  EXPECT_EQ(nearest("ofrce", words), "force");     // letters are swapped
  EXPECT_EQ(nearest("Force", words), "force");     // capital letter
  EXPECT_EQ(nearest("friction", words), "");       // not a typing error
  EXPECT_EQ(nearest(std::string(1000, 'x'), words), "");
}

TEST(SceneError, StaysShortWhateverTheFileSays) {
  const std::string noise(100000, 't');
  const SceneError error =
      error_of([&] { with_body(fmt::format(R"(, "{}": 1)", std::string(100000, 'k'))); });
  EXPECT_LT(std::string_view(error.what()).size(), 1000U);
  EXPECT_LT(std::string_view(error_of([&] { parse_scene(noise, "test"); }).what()).size(), 1000U);
}

TEST(File, ThatIsMissingOrAFolderIsNamed) {
  EXPECT_EQ(error_of([] { read_scene_file("no/such/scene.json"); }).file(), "no/such/scene.json");
  EXPECT_NE(error_of([] { read_scene_file("no/such/scene.json"); }).found().find("No such file"),
            std::string::npos);
  EXPECT_EQ(error_of([] { read_scene_file("."); }).found(), "a folder");
}

TEST(File, OfMoreThan64MiBIsRefused) {
  EXPECT_EQ(error_of([] { parse_scene(std::string((64U << 20) + 1, '1'), "test"); }).accepted(),
            "at most 67108864 bytes");
}

TEST(Reader, TakesAHundredThousandBodiesAndNoMore) {
  std::string bodies;
  for (int k = 0; k < 100'000; ++k)
    bodies += fmt::format(R"({{"name":"{}","mass":1,"inertia":[1,1,1],"position":[0,0,0]}},)", k);
  const std::string last = R"({"name":"last","mass":1,"inertia":[1,1,1],"position":[0,0,0]}]})";
  const std::string too_many = R"({"trivium":1,"bodies":[)" + bodies + last;
  EXPECT_EQ(error_of([&] { parse_scene(too_many, "test"); }).accepted(), "at most 100000");
  const std::string most = R"({"trivium":1,"bodies":[)" + bodies.substr(0, bodies.size() - 1) + "]}";
  EXPECT_EQ(parse_scene(most, "test").bodies.size(), 100'000U);
}

}  // namespace
}  // namespace trivium::scenes
