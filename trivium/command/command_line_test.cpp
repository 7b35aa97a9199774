/// The trivium command as a user meets it, and what all programs have in common: output, messages, exit
/// codes.

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
  ASSERT_EQ(s["formulations"].size(), 4u);
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
  EXPECT_NE(wrong.err.find("hinge: its axes z_i and z_j are antiparallel"), std::string::npos) << wrong.err;
  EXPECT_NE(wrong.err.find("turn the body or the axis"), std::string::npos) << wrong.err;
  EXPECT_EQ(wrong.err.find("--assemble"), std::string::npos) << wrong.err;
  const Outcome assembled = run("trivium solve --assemble " + hung_backwards());
  EXPECT_NE(assembled.err.find("turn the body or the axis"), std::string::npos) << assembled.err;
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

TEST(Check, ReportsRankRedundancyAndSparsity) {
  const Outcome r = run("trivium check n_four_bar_40 --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json c = json::parse(r.out);
  EXPECT_EQ(c["rank"], 485);
  EXPECT_EQ(c["redundant"].size(), 120u);
  for (const json& matrix : c["augmented_matrix"]) EXPECT_LT(matrix["percent"], 3.0) << matrix["formulation"];
}

/// The rank is decided on a dense matrix; what is sparse is reported of a scene of any size.
TEST(Check, ReportsAllButTheRankOfALargeScene) {
  const std::string file = temporary("tree.json").string();
  ASSERT_EQ(run("trivium generate tree 1000 --out " + file).exit_code, 0);
  const Outcome r = run("trivium check " + file + " --json");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_NE(r.err.find("rank and redundant rows are not determined"), std::string::npos) << r.err;
  const json c = json::parse(r.out);
  EXPECT_EQ(c["nb"], 1000);
  EXPECT_TRUE(c["consistent"]);
  EXPECT_FALSE(c.contains("rank"));
  EXPECT_NE(run("trivium check " + file).out.find("not determined"), std::string::npos);
}

TEST(List, NamesScenesFormulationsJointsAndEffects) {
  const Outcome r = run("trivium list --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json l = json::parse(r.out);
  EXPECT_GE(l["scenes"].size(), 30u);
  EXPECT_EQ(l["formulations"].size(), 4u);
  EXPECT_EQ(l["constraints"].size(), 15u);
  EXPECT_EQ(l["effects"].size(), 5u);
}

TEST(List, CountsBodiesInWords) {
  const Outcome r = run("trivium list");
  EXPECT_NE(r.out.find(" 1 body "), std::string::npos) << r.out;
  EXPECT_NE(r.out.find(" 3 bodies "), std::string::npos) << r.out;
  EXPECT_EQ(r.out.find(" 1 bodies"), std::string::npos) << r.out;
}

TEST(Generate, RefusesANegativeSeed) {
  const Outcome r = run("trivium generate tree 3 --seed -1");
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_NE(r.err.find("--seed: found -1; accepted: a whole number"), std::string::npos) << r.err;
}

TEST(Generate, WritesWhatCheckAccepts) {
  for (const std::string kind : {"chain", "ladder", "tree", "ring", "hub"}) {
    const std::string file = temporary(kind + ".json").string();
    ASSERT_EQ(run("trivium generate " + kind + " 12 --out " + file).exit_code, 0) << kind;
    EXPECT_EQ(run("trivium check " + file).exit_code, 0) << kind;
  }
}

TEST(Generate, RefusesARingOfTwo) {
  const Outcome r = run("trivium generate ring 2");
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_NE(r.err.find("N: found 2; accepted: 3 bars of a ring or more"), std::string::npos) << r.err;
}

/// The fields of every line of a CSV without quoted fields.
std::vector<std::vector<std::string>> csv_lines(const fs::path& file) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream text(slurp(file));
  for (std::string line; std::getline(text, line);) {
    std::istringstream fields(line);
    lines.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) lines.back().push_back(field);
  }
  return lines;
}

TEST(Simulate, WritesEveryBodyReactionAndMultiplierAtExactTimes) {
  const fs::path file = fresh("motion.csv");
  const Outcome r =
      run("trivium simulate spatial_slider_crank --formulation r-p --integrator rkf78 --t-end 0.5 "
          "--output-step 0.125 --out " +
          file.string() + " --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  const auto lines = csv_lines(file);
  ASSERT_EQ(lines.size(), 6u);
  const std::vector<std::string> start(lines[0].begin(), lines[0].begin() + 15);
  EXPECT_EQ(start, (std::vector<std::string>{"t", "crank.x", "crank.y", "crank.z", "crank.e0", "crank.e1",
                                             "crank.e2", "crank.e3", "crank.vx", "crank.vy", "crank.vz",
                                             "crank.wx", "crank.wy", "crank.wz", "rod.x"}));
  EXPECT_EQ(lines[0][1 + 3 * 13], "A.fx");
  const std::vector<std::string> end(lines[0].end() - 3, lines[0].end());
  EXPECT_EQ(end, (std::vector<std::string>{"energy", "phi", "phi_dot"}));
  for (std::size_t k = 1; k < lines.size(); ++k) {
    EXPECT_EQ(lines[k].size(), lines[0].size());
    EXPECT_EQ(std::stod(lines[k][0]), 0.125 * static_cast<double>(k - 1));
    EXPECT_LE(std::stod(lines[k].back()), 1e-12);
  }
  const json s = json::parse(r.out);
  EXPECT_TRUE(s["complete"]);
  for (const char* counter :
       {"steps", "rejected_steps", "right_sides", "jacobians", "factorisations", "projection_changes"})
    EXPECT_TRUE(s[counter].is_number_integer()) << counter;
  EXPECT_LE(s["drift"]["phi"], 1e-13);
  EXPECT_LE(s["energy"]["unaccounted"], 1e-6);
  EXPECT_EQ(s["rows"].size(), 17u);
}

TEST(Simulate, WritesAnImplicitMethodsOwnLambdaBesideThatOfTheState) {
  const fs::path file = fresh("motion.csv");
  const Outcome r =
      run("trivium simulate spatial_slider_crank --integrator generalized-alpha --step 0.005 --t-end 0.5 "
          "--output-step 0.125 --out " +
          file.string() + " --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const auto lines = csv_lines(file);
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0].back(), "raw_lambda[16]");
  const auto at = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(lines[0].begin(), lines[0].end(), name) - lines[0].begin());
  };
  for (const int k : {0, 1, 7}) {
    const double raw = std::stod(lines.back()[at("raw_lambda[" + std::to_string(k) + "]")]),
                 again = std::stod(lines.back()[at("lambda[" + std::to_string(k) + "]")]);
    EXPECT_NE(raw, again);
    EXPECT_NEAR(raw, again, 0.05 * (1 + std::abs(again)));
  }
  const json s = json::parse(r.out);
  EXPECT_GT(s["newton_iterations"], 100);
  EXPECT_GT(s["drift"]["raw_lambda"], 0);
  EXPECT_LE(s["drift"]["phi"], 1e-13);
  EXPECT_FALSE(s["projection"]);
}

// p and -p are one orientation; what is written moves without jumps
TEST(Simulate, WritesEulerParametersThatDoNotJump) {
  const fs::path file = fresh("motion.csv");
  ASSERT_EQ(run("trivium simulate heavy_top --formulation r-epsilon --t-end 1 --output-step 0.001 --out " +
                file.string())
                .exit_code,
            0);
  const auto lines = csv_lines(file);
  ASSERT_EQ(lines.size(), 1002u);
  for (std::size_t k = 2; k < lines.size(); ++k)
    for (std::size_t e = 4; e < 8; ++e)
      EXPECT_LE(std::abs(std::stod(lines[k][e]) - std::stod(lines[k - 1][e])), 0.1) << lines[k][0];
}

TEST(Simulate, CtrlCLeavesTheMotionSoFar) {
  const fs::path file = fresh("motion.csv"), errors = fresh("said");
  const Outcome r = run("trivium simulate stewart_platform --t-end 1e6 --output-step 0.01 --out " +
                        file.string() + " 2>" + errors.string() + " & sleep 1; kill -INT $!; wait $!");
  EXPECT_EQ(r.exit_code, 130);
  EXPECT_NE(slurp(errors).find("interrupted at t = "), std::string::npos) << slurp(errors);
  const auto lines = csv_lines(file);
  ASSERT_GT(lines.size(), 10u);
  for (const auto& line : lines) EXPECT_EQ(line.size(), lines[0].size());
}

// and its last state, wherever that is between outputs
TEST(Simulate, CtrlCReportsTheStateThatWasReached) {
  const fs::path file = fresh("motion.csv"), report = fresh("report");
  const Outcome r = run("trivium simulate stewart_platform --t-end 1e6 --output-step 1e5 --json --out " +
                        file.string() + " >" + report.string() + " & sleep 1; kill -INT $!; wait $!");
  EXPECT_EQ(r.exit_code, 130);
  const auto lines = csv_lines(file);
  ASSERT_EQ(lines.size(), 3u);
  const json s = json::parse(slurp(report));
  EXPECT_EQ(std::stod(lines[2][0]), s["reached"]);
  EXPECT_NEAR(s["energy"]["end"].get<double>() - s["energy"]["start"].get<double>(), s["energy"]["work"],
              1e-3);
}

TEST(Simulate, AMotionThatCannotGoOnIsKeptUntilThere) {
  // a bead on a spring without length: its force has no direction where it arrives
  const std::string scene = temporary_scene("caught.json", R"({"trivium": 1, "name": "caught",
    "bodies": [{"name": "bead", "mass": 1, "inertia": [1, 1, 1], "position": [1, 0, 0], "velocity": [-1, 0, 0]}],
    "effects": [{"type": "spring_damper", "name": "catcher", "i": {"body": "ground"}, "j": {"body": "bead"}, "damping": 1e6}]})");
  const fs::path file = fresh("motion.csv");
  const Outcome r = run("trivium simulate " + scene +
                        " --t-end 10 --integrator rkf78 --step 0.5 --output-step 0.5 --out " + file.string());
  EXPECT_EQ(r.exit_code, 3);
  EXPECT_EQ(r.out, "");
  EXPECT_TRUE(r.err.starts_with("error: " + scene + ": ")) << r.err;
  EXPECT_NE(r.err.find("holds the motion until t = "), std::string::npos) << r.err;
  EXPECT_GE(csv_lines(file).size(), 2u);
}

TEST(Simulate, AMotionThatCannotGoOnSaysSoInJson) {
  const Outcome r = run("trivium simulate heavy_top --integrator hem4 --step 0.5 --t-end 5 --json");
  EXPECT_EQ(r.exit_code, 3);
  const json s = json::parse(r.out);
  EXPECT_FALSE(s["complete"]);
  EXPECT_EQ(s["last_output"], 0);
  EXPECT_NE(r.err.find(s["error"].get<std::string>()), std::string::npos) << r.out;
}

// no rows to name, and squares that are no numbers
TEST(Simulate, AMotionThatGrowsWithoutBoundIsAnErrorOfTheSolver) {
  const std::string scene = temporary_scene("bound.json", R"({"trivium": 1, "name": "bound",
    "bodies": [{"name": "a", "mass": 1, "inertia": [1, 1, 1], "position": [0, 0, 0]},
               {"name": "b", "mass": 1, "inertia": [1, 1, 1], "position": [1, 0, 0], "velocity": [0, 1, 0]}],
    "effects": [{"type": "spring_damper", "name": "stiff", "i": {"body": "a"}, "j": {"body": "b"},
                 "stiffness": 1e9, "damping": 1e6, "free_length": 0.9}]})");
  for (const char* method : {"dopri5", "hem4", "hedop5", "rattle", "arkode-erk"}) {
    const Outcome r = run("trivium simulate " + scene + " --t-end 10 --step 0.01 --integrator " + method);
    EXPECT_EQ(r.exit_code, 3) << method << r.out;
    EXPECT_NE(r.err, "") << method;
  }
}

// the one word of the method's would be of forces or rows
TEST(Simulate, AKeptChartThatIsSingularIsNamedWhateverTheMethod) {
  const std::string scene = temporary_scene("gimbal.json", R"({"trivium": 1, "name": "gimbal",
    "bodies": [{"name": "stone", "mass": 2, "inertia": [0.1, 0.2, 0.3], "position": [0, 0, 0],
                "orientation": {"axis_angle": {"axis": [1, 0, 0], "angle": 0.5}},
                "angular_velocity": [-1, 0, 1e-5]}]})");
  for (const char* method : {"dopri5", "abm", "bdf", "hem4", "generalized-alpha", "radau5", "arkode-dirk"}) {
    const Outcome r = run("trivium simulate " + scene + " --formulation r-epsilon --no-reframe --step 0.01 " +
                          "--t-end 2 --integrator " + method);
    EXPECT_EQ(r.exit_code, 3) << method;
    EXPECT_NE(r.err.find("body \"stone\" at t = "), std::string::npos) << r.err;
    EXPECT_NE(r.err.find("leave re-framing on"), std::string::npos) << r.err;
    EXPECT_EQ(run("trivium simulate " + scene +
                  " --formulation r-epsilon --step 0.01 --t-end 2 --integrator " + method)
                  .exit_code,
              0)
        << method;
  }
}

TEST(Simulate, AnInconsistentStartIsAnInputErrorUnlessAssembled) {
  const std::string scene = moving_wrongly();
  EXPECT_EQ(run("trivium simulate " + scene + " --t-end 0.1").exit_code, 2);
  EXPECT_EQ(run("trivium simulate " + scene + " --t-end 0.1 --assemble").exit_code, 0);
}

TEST(Simulate, SaysWhichSingularPositionsItPassed) {
  const Outcome r = run("trivium simulate n_four_bar_1 --t-end 2 --rtol 1e-10 --atol 1e-12 --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_NE(r.err.find("warning: the motion passed"), std::string::npos) << r.err;
  EXPECT_GE(json::parse(r.out)["singular_positions"].size(), 1u);
}

// gnuplot would run what a newline lets out of a string
TEST(Simulate, NamesOfASceneAreTextInItsFigure) {
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) GTEST_SKIP() << "no gnuplot";
  const fs::path file = fresh("motion.svg"), made = fresh("made");
  const std::string scene =
      temporary_scene("named.json", R"({"trivium": 1, "name": "x'\nsystem('touch )" + made.string() +
                                        R"(')\n", "bodies": [{"name": "b`touch )" + made.string() +
                                        R"(`\n", "mass": 1, "inertia": [1, 1, 1], "position": [0, 0, 0]}]})");
  const Outcome r = run("trivium simulate " + scene + " --t-end 1 --output-step 0.1 --plot " + file.string());
  EXPECT_EQ(r.exit_code, 0) << r.err;  // a body at rest: nothing to see, but no error
  EXPECT_FALSE(fs::exists(made));
  EXPECT_NE(slurp(file).find("</svg>"), std::string::npos);
}

TEST(Simulate, DrawsTheMotion) {
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) GTEST_SKIP() << "no gnuplot";
  const fs::path file = fresh("motion.svg");
  const Outcome r = run("trivium simulate four_bar --t-end 1 --plot " + file.string());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_NE(slurp(file).find("</svg>"), std::string::npos);
}

TEST(EveryProgram, HasHelpAndVersion) {
  std::vector<std::string> programs = validations();
  programs.push_back("trivium");
  for (const std::string& program : programs)
    for (const std::string flag : {"--help", "--version"}) {
      const Outcome r = run(program + " " + flag);
      EXPECT_EQ(r.exit_code, 0) << program << flag;
      EXPECT_NE(r.out, "");
    }
  for (const std::string command : {"solve", "simulate", "check", "list", "generate"})
    for (const std::string flag : {" --help", " --version"})
      EXPECT_EQ(run("trivium " + command + flag).exit_code, 0) << command << flag;
}

/// A full disk, as the device that is always full plays it: short output is lost when it is flushed, long
/// output while it is printed.
TEST(EveryProgram, DoesNotPassOverResultsThatCouldNotBeWritten) {
  std::vector<std::string> all{"trivium solve heavy_top", "trivium simulate heavy_top --t-end 0.1",
                               "trivium check n_four_bar_40 --json", "trivium generate chain 100",
                               "trivium --help"};
  for (const std::string& program : validations()) all.push_back(program + " simple_pendulum");
  for (const std::string& words : all) {
    const Outcome r = run(words + " >/dev/full");
    EXPECT_EQ(r.exit_code, 3) << words;
    EXPECT_EQ(r.err, "error: the results could not be written to stdout: No space left on device\n") << words;
  }
}

TEST(EveryProgram, SuggestsTheNearestNameOfTheCatalogue) {
  std::vector<std::string> all = validations();
  all.push_back("trivium solve");
  all.push_back("trivium simulate");
  for (const std::string& program : all)
    for (const std::string name : {"heavy_tpo", "heavy_tpo.json", "heavy_top.json"}) {
      const Outcome r = run(program + " " + name);
      EXPECT_EQ(r.exit_code, 2) << program;
      EXPECT_EQ(r.err,
                "error: " + name +
                    ": no such file, and no such scene in the catalogue; accepted: a path to a scene file, "
                    "or a name that trivium list prints (did you mean \"heavy_top\"?)\n");
    }
}

TEST(EveryProgram, FindsASceneBesideAFolderOfItsName) {
  const fs::path folder = temporary("folder");
  fs::create_directories(folder / "heavy_top");
  const Outcome r = run("trivium solve heavy_top", folder);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_TRUE(r.out.starts_with("heavy_top: ")) << r.out;
}

TEST(Trivium, ListsItsSubcommandsToWhoeverNamesNone) {
  EXPECT_EQ(
      run("trivium").err,
      "error: no subcommand; accepted: solve, simulate, check, list, generate; trivium --help says more\n");
  EXPECT_EQ(run("trivium foo").err,
            "error: unknown subcommand \"foo\"; accepted: solve, simulate, check, list, generate; trivium "
            "--help says "
            "more\n");
  EXPECT_NE(run("trivium slove heavy_top").err.find("(did you mean \"solve\"?)"), std::string::npos);
  for (const std::string words : {"trivium", "trivium foo", "trivium slove heavy_top"})
    EXPECT_EQ(run(words).exit_code, 2) << words;
}

TEST(EveryProgram, AnswersMisuseWithExitCodeTwo) {
  for (const std::string words :
       {"trivium",
        "trivium solv heavy_top",
        "trivium solve",
        "trivium solve no_such_scene",
        "trivium solve heavy_top --scalar half",
        "trivium solve heavy_top --sequence 312x",
        "trivium solve heavy_top --t nan",
        "trivium check heavy_top --t inf",
        "trivium simulate heavy_top --integrator euler",
        "trivium simulate heavy_top --formulation r-q",
        "trivium simulate heavy_top --t-end -1",
        "trivium simulate heavy_top --step 0.3 --t-end 1",
        "trivium simulate heavy_top --step 0.1 --rtol 1e-3",
        "trivium simulate heavy_top --rtol 0",
        "trivium simulate heavy_top --integrator bulirsch-stoer --step 0.1 --t-end 1",
        "trivium simulate heavy_top --integrator generalized-alpha --t-end 1",
        "trivium simulate heavy_top --integrator generalized-alpha --step 0.01 --t-end 1 --no-projection",
        "trivium simulate heavy_top --integrator bdf --step 0.01 --t-end 1 --baumgarte 1 1",
        "trivium simulate heavy_top --integrator bdf --step 0.01 --t-end 1 --order 6",
        "trivium simulate heavy_top --integrator hht --step 0.01 --t-end 1 --rho 0.5",
        "trivium simulate heavy_top --integrator rattle --step 0.01 --t-end 1 --formulation r-p",
        "trivium simulate heavy_top --integrator dopri5 --full-newton",
        "trivium simulate heavy_top --baumgarte 1",
        "trivium simulate heavy_top --baumgarte nan 1",
        "trivium simulate heavy_top --rtol 1e-30 --atol 1e-30",
        "trivium simulate heavy_top --integrator hem4 --step 0.01 --t-end 1 --baumgarte 1 1",
        "convergence_order --method cvode-bdf",
        "trivium simulate heavy_top --plot motion.png",
        "trivium simulate heavy_top --out no_such_folder/motion.csv",
        "lambda_invariance no_such_scene",
        "precision_ladder --no-such-option"}) {
    const Outcome r = run(words);
    EXPECT_EQ(r.exit_code, 2) << words;
    EXPECT_NE(r.err, "") << words;
  }
}

}  // namespace
}  // namespace trivium::test
