/// The public interface: scenes built in C++, states, errors. Its numbers equal those of the templates.

#include <gtest/gtest.h>

#include <filesystem>

#include "formulations/side_by_side.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "trivium/testing/front_door_scenes.hpp"
#include "trivium/trivium.hpp"

namespace trivium {
namespace {

namespace fs = std::filesystem;

using test::path_of, test::scene_of, test::temporary;

Scene pendulum() {
  Scene scene("pendulum");
  scene.add_body({.name = "rod",
                  .mass = 2,
                  .inertia = {0.2, 0.2, 0.01},
                  .position = {0, 0, -0.5},
                  .orientation = {{"axis_angle", {{"axis", {0, 0, 1}}, {"angle", 0.5}}}},
                  .angular_velocity = {0, 0, 3}});
  scene.add_constraint("spherical", "tip", {.body = "ground"}, {.body = "rod", .point = {0, 0, 0.5}});
  scene.add_effect("gravity", {{"acceleration", {0, 0, -9.81}}});
  return scene;
}

/// The Error that a call throws.
template <class Call>
Error error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return {ErrorKind::input, ""};
}

TEST(FrontDoor, ASceneThatIsBuiltIsTheSceneOfItsFile) {
  Scene scene("all");
  scene.add_body({.name = "a", .mass = 1, .inertia = {1, 1, 1}});
  scene.add_body({.name = "b",
                  .mass = 1.5,
                  .inertia = list({{1, 0.1, 0}, {0.1, 1, 0}, {0, 0, 1}}),
                  .position = Components{1, 2, 3},
                  .orientation = {{"euler_angles", {0.1, 0.2, 0.3}}, {"sequence", "123"}}});
  scene.add_body({.name = "c", .mass = 1, .inertia = {1, 1, 9}, .unphysical_inertia = true});
  scene.add_constraint("revolute", "r", {.body = "a", .axis = {0, 1, 0}}, {.body = "b", .axis = {0, 1, 0}});
  scene.add_constraint(
      "cd", "drive", {.body = "ground"}, {.body = "c"},
      {{"direction", {1, 0, 0}},
       {"f", {{"kind", "sin"}, {"of", {{"kind", "polynomial"}, {"coefficients", {0, 2}}}}}}});
  scene.add_effect("force",
                   {{"body", "c"}, {"force", list({1, {{"kind", "cos"}, {"of", 2}}, 0})}, {"frame", "body"}});
  scene.add_effect("spring_damper",
                   {{"i", {{"body", "a"}, {"point", {1, 0, 0}}}}, {"j", {{"body", "b"}}}, {"stiffness", 10}});
  scenes::Scene expected = scenes::parse_scene(R"({"trivium": 1, "name": "all", "bodies": [
    {"name": "a", "mass": 1, "inertia": [1, 1, 1], "position": [0, 0, 0]},
    {"name": "b", "mass": 1.5, "inertia": [[1, 0.1, 0], [0.1, 1, 0], [0, 0, 1]], "position": [1, 2, 3],
     "orientation": {"euler_angles": [0.1, 0.2, 0.3], "sequence": "123"}},
    {"name": "c", "mass": 1, "inertia": [1, 1, 9], "position": [0, 0, 0], "unphysical_inertia": true}],
    "constraints": [
    {"type": "revolute", "name": "r", "i": {"body": "a", "axis": [0, 1, 0]}, "j": {"body": "b", "axis": [0, 1, 0]}},
    {"type": "cd", "name": "drive", "i": {"body": "ground"}, "j": {"body": "c"}, "direction": [1, 0, 0],
     "f": {"kind": "sin", "of": {"kind": "polynomial", "coefficients": [0, 2]}}}],
    "effects": [
    {"type": "force", "body": "c", "force": [1, {"kind": "cos", "of": 2}, 0], "frame": "body"},
    {"type": "spring_damper", "i": {"body": "a", "point": [1, 0, 0]}, "j": {"body": "b"}, "stiffness": 10}]})",
                                               "expected");
  EXPECT_EQ(scene.contents().scene, expected);
  const fs::path file = temporary("json");
  scene.write(file);
  EXPECT_EQ(read_scene(file).contents().scene, expected);
}

TEST(FrontDoor, ASceneThatIsBuiltIsCheckedAsAFileIs) {
  Scene scene = pendulum();
  scene.add_effect("torsional_spring_damper", {{"joint", "tip"}});
  const Error joint = error_of([&] { scene.bodies(); });
  EXPECT_EQ(joint.kind(), ErrorKind::input);
  EXPECT_EQ(joint.where(), "scene \"pendulum\": /effects/1/joint");
  Scene light("light");
  light.add_body({.name = "a", .mass = -1, .inertia = {1, 1, 1}});
  EXPECT_EQ(error_of([&] { solve(light); }).where(), "scene \"light\": /bodies/0/mass");
  Scene slip = pendulum();
  slip.add_effect("gravty");
  EXPECT_NE(std::string(error_of([&] { solve(slip); }).what()).find("did you mean \"gravity\"?"),
            std::string::npos);
  Scene infinite("infinite");
  infinite.add_body({.name = "a", .mass = std::numeric_limits<double>::quiet_NaN(), .inertia = {1, 1, 1}});
  EXPECT_EQ(error_of([&] { solve(infinite); }).where(), "scene \"infinite\": /bodies/0/mass");
}

TEST(FrontDoor, ASceneThatWasReadTakesMoreParts) {
  Scene scene = read_scene(path_of("heavy_top"));
  const Scene before = scene;
  scene.add_effect("torque", {{"body", "top"}, {"torque", {0, 0, 1}}});
  EXPECT_EQ(scene.contents().scene.effects.size(), before.contents().scene.effects.size() + 1);
  EXPECT_EQ(scene.contents().scene.bodies, before.contents().scene.bodies);
  EXPECT_EQ(scene.contents().scene.description, before.contents().scene.description);
  EXPECT_EQ(scene.contents().scene.reference, before.contents().scene.reference);
  EXPECT_NE(scene.contents().scene.reference, "");
}

TEST(FrontDoor, SolvesAsTheRoomsBehindItDo) {
  for (const char* name : {"spatial_slider_crank", "four_bar", "heavy_top", "stewart_platform", "door"}) {
    const Model<double> model = make_model<double>(test::catalogue_scene(name));
    const SideBySide<double> expected = side_by_side(model, analyse_rows(model));
    const Solutions all = solve_in_all(read_scene(path_of(name)));
    ASSERT_EQ(all.solved.size(), formulation_names().size()) << name;
    EXPECT_EQ(all.lambda_difference, expected.discrepancy().lambda);
    EXPECT_EQ(*all.lambda_bound, expected.lambda_bound());
    for (std::size_t f = 0; f < all.solved.size(); ++f) {
      const Solution& one = all.solved[f];
      const FormulationResult<double>& of = expected.formulations[f];
      EXPECT_EQ(one.formulation, of.name);
      EXPECT_EQ(one.solver, "printed");
      EXPECT_EQ(one.lambda_is_unique, expected.rows.unique);
      EXPECT_EQ(one.charts, of.charts);
      EXPECT_EQ(one.dependent.size(), expected.rows.dependent.size());
      EXPECT_GT(one.lambda_error, 0);
      for (std::size_t k = 0; k < one.lambda.size(); ++k) {
        EXPECT_EQ(one.lambda[k], of.solution.lambda[static_cast<Eigen::Index>(k)]);
        EXPECT_EQ(one.lambda_of(one.names->rows[k]), one.lambda[k]);
      }
      for (std::size_t b = 0; b < one.bodies.size(); ++b)
        for (std::size_t x = 0; x < 3; ++x) {
          EXPECT_EQ(one.bodies[b].r_ddot[x], of.solution.r_ddot[b][static_cast<Eigen::Index>(x)]);
          EXPECT_EQ(one.bodies[b].omega_bar_dot[x],
                    of.solution.omega_bar_dot[b][static_cast<Eigen::Index>(x)]);
        }
      for (std::size_t k = 0; k < one.reactions.size(); ++k)
        EXPECT_EQ(one.reaction(one.names->joints[k]).force[2], of.reactions[k].force[2]);
    }
  }
}

TEST(FrontDoor, NamesTheTwoBodiesOfEveryJoint) {
  for (const char* name : {"four_bar", "stewart_platform", "heavy_top"}) {
    const Scene scene = read_scene(path_of(name));
    const scenes::Scene& of = scene.contents().scene;
    const Names names = *solve(scene).names;
    ASSERT_EQ(names.joint_bodies_i.size(), of.constraints.size()) << name;
    ASSERT_EQ(names.joint_bodies_j.size(), of.constraints.size()) << name;
    for (std::size_t k = 0; k < of.constraints.size(); ++k) {
      EXPECT_EQ(names.joint_bodies_i[k], of.body_name(of.constraints[k].i.body)) << names.joints[k];
      EXPECT_EQ(names.joint_bodies_j[k], of.body_name(of.constraints[k].j.body)) << names.joints[k];
    }
  }
}

TEST(FrontDoor, ChecksWhatAStateIs) {
  const Check check = trivium::check(read_scene(path_of("four_bar")));
  EXPECT_EQ(*check.rank, 17);
  EXPECT_EQ(*check.degrees_of_freedom, 1);
  EXPECT_TRUE(check.is_consistent);
  EXPECT_EQ(check.rows.size(), 20u);
  EXPECT_EQ(std::count_if(check.rows.begin(), check.rows.end(),
                          [](const RowCheck& row) { return row.is_dependent; }),
            3);
  EXPECT_GT(check.kinetic_energy, 0);
}

TEST(FrontDoor, AStateThatMissesItsConstraintsIsAnErrorUntilItIsAssembled) {
  Scene scene("off", 0.25);
  scene.add_body({.name = "rod", .mass = 2, .inertia = {0.2, 0.2, 0.01}, .position = {0, 0.01, -0.5}});
  scene.add_constraint("spherical", "tip", {.body = "ground"}, {.body = "rod", .point = {0, 0, 0.5}});
  EXPECT_FALSE(trivium::check(scene).is_consistent);
  for (const Error& error :
       {error_of([&] { solve(scene); }), error_of([&] { solve_in_all(scene); }),
        error_of([&] { simulate(scene, {.end = 1}); }), error_of([&] { compare(scene); })}) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.where(), "scene \"off\"");
    EXPECT_EQ(error.when(), 0.25);
    EXPECT_NE(std::string(error.what()).find("tip.cd(e_y)"), std::string::npos) << error.what();
  }
  const Scene assembled = assemble(scene);
  EXPECT_TRUE(trivium::check(assembled).is_consistent);
  EXPECT_EQ(assembled.t(), 0.25);
  EXPECT_EQ(solve(assembled).warnings.size(), 0u);
}

TEST(FrontDoor, NamesThatThereAreNotAreErrorsThatSayWhichThereAre) {
  const Scene scene = pendulum();
  EXPECT_NE(std::string(error_of([&] { solve(scene, {.formulation = "r-omga"}); }).what())
                .find("did you mean \"r-omega\"?"),
            std::string::npos);
  EXPECT_EQ(error_of([&] { solve(scene, {.sequence = "311"}); }).kind(), ErrorKind::input);
  EXPECT_EQ(error_of([&] { simulate(scene, {.integrator = "euler"}); }).kind(), ErrorKind::input);
  EXPECT_EQ(error_of([&] { compare(scene, {.formulations = {"r-p"}}); }).kind(), ErrorKind::input);
  EXPECT_EQ(error_of([&] { compare(scene, {.formulations = {"r-p", "r-q"}}); }).kind(), ErrorKind::input);
  EXPECT_EQ(error_of([&] { read_scene("heavy_pot"); }).where(), "heavy_pot");
  const Solution at = solve(scene);
  EXPECT_NE(std::string(error_of([&] { at.point("rid", {}); }).what()).find("did you mean \"rod\"?"),
            std::string::npos);
}

TEST(FrontDoor, SettingsThatCannotBeAreErrorsThatNameThem) {
  const Scene scene = pendulum();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   infinity = std::numeric_limits<double>::infinity();
  for (const SimulateSettings& settings :
       {SimulateSettings{.rtol = -1}, SimulateSettings{.atol = nan}, SimulateSettings{.end = infinity},
        SimulateSettings{.end = -1}, SimulateSettings{.step = 0}, SimulateSettings{.output_step = -1},
        SimulateSettings{.max_step = 0}, SimulateSettings{.step = 0.1, .max_step = 0.1},
        SimulateSettings{.baumgarte = {{nan, 1}}}, SimulateSettings{.baumgarte = {{-1, 1}}},
        SimulateSettings{.projects = false, .baumgarte = {{1, 1}}}}) {
    EXPECT_EQ(error_of([&] { simulate(scene, settings); }).kind(), ErrorKind::input);
    EXPECT_EQ(error_of([&] { compare(scene, {.run = settings}); }).kind(), ErrorKind::input);
  }
  EXPECT_EQ(error_of([&] { compare(scene, {.states = 0}); }).kind(), ErrorKind::input);
  EXPECT_EQ(error_of([&] { solve(Scene("late", nan)); }).kind(), ErrorKind::input);
  EXPECT_EQ(error_of([&] { read_scene(path_of("heavy_top"), nan); }).kind(), ErrorKind::input);
}

TEST(FrontDoor, ASceneThatWasMovedFromIsAnError) {
  EXPECT_EQ(error_of([&] { Solution().body("x"); }).kind(),
            ErrorKind::input);  // a default Solution: no names
  Scene scene = pendulum();
  const Scene taken = std::move(scene);
  EXPECT_EQ(taken.bodies().size(), 1u);
  EXPECT_EQ(error_of([&] { scene.bodies(); }).kind(), ErrorKind::input);               // NOLINT: on purpose
  EXPECT_EQ(error_of([&] { scene.add_effect("gravity"); }).kind(), ErrorKind::input);  // NOLINT
}

TEST(FrontDoor, ErrorsSayWhichBodyAndWhen) {
  const Scene turned = pendulum();
  const Error chart =
      error_of([&] { simulate(turned, {.formulation = "r-epsilon", .end = 1, .reframe = false}); });
  EXPECT_EQ(chart.kind(), ErrorKind::model);
  EXPECT_EQ(chart.where(), "scene \"pendulum\": body \"rod\"");
  EXPECT_EQ(chart.when(), 0);
  const Error step = error_of([&] {
    simulate(read_scene(path_of("flyball_governor")), {.integrator = "rkf78", .end = 1, .step = 0.01});
  });
  EXPECT_EQ(step.kind(), ErrorKind::integration);
  EXPECT_NE(step.where().find(".json: body \"shaft\""), std::string::npos) << step.where();
  ASSERT_TRUE(step.when().has_value());
  EXPECT_GT(*step.when(), 0);
}

TEST(FrontDoor, MechanismsThatAreTooLargeForTheDenseSolverAreSolvedAlongTheirGraph) {
  const Scene chain = scene_of(scenes::chain(1000));
  const Check check = trivium::check(chain);
  EXPECT_EQ(check.solver, "structured");
  EXPECT_EQ(*check.rank, static_cast<int>(check.rows.size()));
  EXPECT_FALSE(check.condition.has_value());
  const Solutions all = solve_in_all(chain);
  EXPECT_TRUE(all.failed.empty());
  EXPECT_FALSE(all.lambda_bound.has_value());
  EXPECT_LE(all.lambda_difference, 1e-10);
  for (const Solution& one : all.solved) {
    EXPECT_EQ(one.solver, "structured");
    EXPECT_FALSE(one.condition.has_value());
    EXPECT_TRUE(one.warnings.empty()) << one.warnings.front();
  }
}

TEST(FrontDoor, BeyondTheDenseSolverABodyWithoutInertiaAboutAnAxisIsSolvedWithoutNorms) {
  const Solutions all = solve_in_all(scene_of(scenes::ladder(225)));
  EXPECT_TRUE(all.failed.empty());
  EXPECT_TRUE(std::isnan(all.lambda_difference));
  EXPECT_FALSE(all.solved.front().dependent.empty());
}

TEST(FrontDoor, TheScenesOfAnInstalledCatalogueAreFoundBesideTheHeader) {
  const std::filesystem::path prefix = temporary("prefix"), scenes = prefix / "share" / "trivium" / "scenes";
  std::filesystem::create_directories(scenes);
  std::filesystem::copy_file(path_of("heavy_top"), scenes / "only_here.json",
                             std::filesystem::copy_options::overwrite_existing);
  const std::filesystem::path header = prefix / "include" / "trivium" / "scene.hpp";
  EXPECT_EQ(catalogue_scenes(header), std::vector<std::string>{"only_here"});
  EXPECT_EQ(read_scene("only_here", {}, header).bodies(), std::vector<std::string>{"top"});
}

}  // namespace
}  // namespace trivium
