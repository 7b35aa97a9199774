/// `trivium solve`, run as a user does: its output, its error messages and its exit codes.

#include "trivium/command/testing/run_program.hpp"

namespace trivium::test {
namespace {

TEST(Solve, PrintsTheDocumentedJson) {
  const Outcome r = run("trivium solve four_bar --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json s = json::parse(r.out);
  EXPECT_EQ(s["scene"], "four_bar");
  EXPECT_EQ(s["nb"], 3);
  EXPECT_EQ(s["nc"], 20);
  EXPECT_EQ(s["rank"], 17);
  EXPECT_EQ(s["dof"], 1);
  EXPECT_EQ(s["rows"].size(), 20u);
  EXPECT_GT(s["condition"], 1.0);
  for (const char* key : {"lambda", "r_ddot", "omega_bar_dot"})
    EXPECT_LT(s["discrepancy"][key], 1e-13) << key;
  ASSERT_EQ(s["formulations"].size(), json::parse(run("trivium list --json").out)["formulations"].size());
  for (const json& f : s["formulations"]) {
    EXPECT_EQ(f["lambda"].size(), 20u);
    EXPECT_EQ(f["lambda_unique"], json(std::vector<bool>(20, false)));
    EXPECT_EQ(f["r_ddot"].size(), 3u);
    EXPECT_EQ(f["omega_bar_dot"][2].size(), 3u);
    EXPECT_GT(f["lambda_error_estimate"], 0.0);
    EXPECT_GT(f["acceleration_error_estimate"], 0.0);
    EXPECT_EQ(f["reactions"].size(), 4u);
    EXPECT_EQ(f["reactions"][0]["force"].size(), 3u);
    EXPECT_TRUE(f["reactions"][0].contains("joint") && f["reactions"][0].contains("body"));
  }
}

TEST(Solve, FiftyDigitsArePrintedWithAllTheirDigits) {
  const Outcome r = run("trivium solve simple_pendulum --scalar 50 --formulation r-p --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const std::string lambda = r.out.substr(r.out.find("\"lambda\": [") + 11, 52);
  EXPECT_EQ(lambda.find(','), std::string::npos) << lambda;
  EXPECT_TRUE(json::accept(r.out));
}

TEST(Solve, ASingularRawChartIsTheErrorOfItsFormulationAlone) {
  const Outcome upright = run("trivium solve asymmetric_free_body --sequence 313 --no-reframe --json");
  ASSERT_EQ(upright.exit_code, 0) << upright.err;
  const json s = json::parse(upright.out);
  EXPECT_TRUE(formulation(s, "r-epsilon").contains("error"));
  EXPECT_TRUE(formulation(s, "r-omega").contains("lambda"));
  EXPECT_TRUE(formulation(s, "r-p").contains("lambda"));
  EXPECT_NE(upright.err.find("r-epsilon"), std::string::npos);
  const Outcome alone = run("trivium solve asymmetric_free_body --formulation r-epsilon --no-reframe");
  EXPECT_EQ(alone.exit_code, 3);
}

TEST(Solve, NearGimbalLockThePrintedFormSaysSoItself) {
  const std::string scene = temporary_scene("near_lock.json", R"({
    "trivium": 1, "name": "near_lock",
    "bodies": [{"name": "top", "mass": 2, "inertia": [[0.3, 0.02, 0], [0.02, 0.4, 0.01], [0, 0.01, 0.5]],
                "position": [0, 0, 0], "orientation": {"euler_angles": [0.3, 1e-5, 0.7], "sequence": "313"},
                "angular_velocity": [0, 0, 0]}],
    "constraints": [{"type": "spherical", "name": "pivot", "i": {"body": "ground"}, "j": {"body": "top"}}],
    "effects": [{"type": "torque", "body": "top", "torque": [1, 2, 3]}, {"type": "force", "body": "top", "point": [0.1, 0.2, 0.3], "force": [4, 5, 6]}]})");
  const Outcome r = run("trivium solve " + scene + " --no-reframe --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json s = json::parse(r.out);
  const json& printed = formulation(s, "r-epsilon");
  EXPECT_GT(
      printed["lambda_error_estimate"].get<double>() + printed["acceleration_error_estimate"].get<double>(),
      1e-6);
  EXPECT_LT(formulation(s, "r-omega")["lambda_error_estimate"], 1e-14);
  EXPECT_LT(formulation(s, "r-epsilon-omega-first")["lambda_error_estimate"], 1e-9);
  EXPECT_NE(r.err.find("r-epsilon: "), std::string::npos) << r.err;
}

TEST(Solve, AnInconsistentStartIsAnInputErrorThatNamesItsRows) {
  std::string text = slurp(TRIVIUM_SCENES_DIR "/simple_pendulum.json");
  const std::size_t at = text.find("\"position\": [") + 13;
  text.replace(at, text.find(']', at) - at, "9, 9, 9");
  const std::string scene = temporary_scene("moved.json", text);
  const Outcome r = run("trivium solve " + scene);
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_EQ(r.out, "");
  EXPECT_NE(r.err.find("position: residual"), std::string::npos) << r.err;
  EXPECT_NE(r.err.find("--assemble"), std::string::npos);
}

TEST(Solve, AWrongBranchIsNotAdvisedToAssemble) {
  const Outcome wrong = run("trivium solve " + hung_backwards());
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("joint \"hinge\": the axes z_i and z_j are antiparallel"), std::string::npos)
      << wrong.err;
  EXPECT_NE(wrong.err.find("reverse the axis in the scene file"), std::string::npos) << wrong.err;
  EXPECT_EQ(wrong.err.find("--assemble"), std::string::npos) << wrong.err;
  const Outcome assembled = run("trivium solve --assemble " + hung_backwards());
  EXPECT_NE(assembled.err.find("reverse the axis in the scene file"), std::string::npos) << assembled.err;
  EXPECT_EQ(assembled.err.find("move the bodies"), std::string::npos) << assembled.err;
}

TEST(Solve, AssembleProjectsAndSaves) {
  const std::string scene = moving_wrongly();
  const std::string saved = temporary("assembled.json").string();
  EXPECT_EQ(run("trivium check " + scene).exit_code, 2);
  EXPECT_EQ(run("trivium solve " + scene + " --assemble --save " + saved).exit_code, 0);
  EXPECT_EQ(run("trivium check " + saved).exit_code, 0);
}

TEST(Solve, RefusesToSaveToWhatIsNoFileBeforeItReadsTheScene) {
  const fs::path fifo = fresh("fifo.json");
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  for (const std::string& file : {fifo.string(), testing::TempDir(), std::string("\"\"")}) {
    const Outcome r = run("trivium solve no_such_scene --assemble --save " + file);
    EXPECT_EQ(r.exit_code, 2) << file;
    EXPECT_NE(r.err.find("--save: "), std::string::npos) << r.err;
    EXPECT_EQ(r.err.find("no_such_scene"), std::string::npos) << r.err;
  }
  EXPECT_TRUE(fs::is_fifo(fifo));
}

TEST(Solve, AMassThatNothingHoldsIsAnErrorThatNamesTheBody) {
  const std::string scene =
      temporary_scene("free_point.json", R"({"trivium": 1, "name": "free_point", "bodies":
    [{"name": "speck", "mass": 1, "inertia": [0, 0, 0], "position": [0, 0, 0]}]})");
  const Outcome r = run("trivium solve " + scene);
  EXPECT_EQ(r.exit_code, 3);
  EXPECT_NE(r.err.find("speck"), std::string::npos) << r.err;
}

TEST(Solve, RowsThatNoAccelerationSatisfiesAreAnErrorThatNamesThemAndTheFile) {
  const std::string scene = dead_point();
  const Outcome r = run("trivium solve " + scene);
  EXPECT_EQ(r.exit_code, 3);
  EXPECT_EQ(r.out, "");
  EXPECT_NE(r.err.find("right.d"), std::string::npos) << r.err;
  EXPECT_TRUE(r.err.starts_with("error: " + scene + ": ")) << r.err;
  EXPECT_EQ(run("trivium check " + scene).exit_code, 2);
}

TEST(Solve, MechanismsTooLargeForTheDenseSolverAreSolvedAlongTheirGraph) {
  const std::string file = temporary("chain.json").string();
  ASSERT_EQ(run("trivium generate chain 1000 --out " + file).exit_code, 0);
  const Outcome r = run("trivium solve " + file + " --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  const json s = json::parse(r.out);
  EXPECT_EQ(s["solver"], "structured");
  EXPECT_TRUE(s["condition"].is_null());
  EXPECT_LE(s["discrepancy"]["lambda"], 1e-10);
  EXPECT_NE(run("trivium solve " + file).out.find("solved by the structured solver"), std::string::npos);
  // in other Scalars than double only the printed system is available
  const Outcome quad = run("trivium solve " + file + " --scalar quad");
  EXPECT_EQ(quad.exit_code, 3);
  EXPECT_NE(quad.err.find("dense augmented matrix"), std::string::npos) << quad.err;
}

}  // namespace
}  // namespace trivium::test
