/// `trivium simulate`, run as a user does: its files, its report, and the ways in which a run can end.

#include "trivium/command/testing/run_program.hpp"

namespace trivium::test {
namespace {

/// The fields of every line of a CSV file without quoted fields.
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

// p and -p are the same orientation; the file must not jump from one to the other
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

// loose tolerances lose half a turn of a driven angle that swings fast
TEST(Simulate, AMotionThatChangesToAnotherBranchOfADriverEndsWithAnErrorThatNamesTheJoint) {
  const std::string scene = temporary_scene("driven.json", R"({"trivium": 1, "name": "driven",
    "bodies": [{"name": "b", "mass": 1, "inertia": [0.1, 0.1, 0.1], "position": [0.1, 0, 0],
                "velocity": [0, 150, 0], "angular_velocity": [0, 0, 1500]}],
    "constraints": [
      {"type": "revolute", "name": "r", "i": {"body": "ground", "axis": [0, 0, 1], "x": [1, 0, 0]},
       "j": {"body": "b", "point": [-0.1, 0, 0], "axis": [0, 0, 1], "x": [1, 0, 0]}},
      {"type": "rotation_driver", "name": "d", "i": {"body": "ground", "axis": [0, 0, 1], "x": [1, 0, 0]},
       "j": {"body": "b", "axis": [0, 0, 1], "x": [1, 0, 0]},
       "angle": {"kind": "harmonic", "offset": 0, "amplitude": 1.5, "angular_frequency": 1000, "phase": 0}}]})");
  const Outcome r = run("trivium simulate " + scene +
                        " --integrator radau5 --rtol 0.1 --atol 0.1 --t-end 1 --output-step 0.01");
  EXPECT_EQ(r.exit_code, 3) << r.out;
  EXPECT_NE(r.err.find("the motion has changed to another branch: joint \"d\": the angle of the joint is 180 "
                       "degrees from"),
            std::string::npos)
      << r.err;
}

/// Runs `words` in an empty folder, where no file can grow beyond 32 kB, as on a full disk.
Outcome run_on_a_full_disk(const std::string& words) {
  const fs::path folder = temporary("folder");
  fs::remove_all(folder);
  fs::create_directories(folder);
  return run(words, folder.string() + " && trap '' XFSZ && ulimit -f 64");
}

TEST(Simulate, AFullDiskEndsTheRunAndLeavesTheMotionSoFarWhereTheMessageSays) {
  const Outcome r =
      run_on_a_full_disk("trivium simulate heavy_top --t-end 100 --output-step 0.01 --out motion.csv");
  EXPECT_EQ(r.exit_code, 3);
  const std::string says =
      "error: cannot write motion.csv: File too large; the lines that could be written are in ";
  ASSERT_TRUE(r.err.starts_with(says)) << r.err;
  const std::string name = r.err.substr(says.size(), r.err.find('\n') - says.size());
  EXPECT_TRUE(name.find("motion.csv.incomplete-") != std::string::npos) << name;
  const auto lines = csv_lines(temporary("folder") / fs::path(name).filename());
  ASSERT_GT(lines.size(), 10u);
  for (const auto& line : lines) EXPECT_EQ(line.size(), lines[0].size());
  EXPECT_FALSE(fs::exists(temporary("folder") / "motion.csv"));
}

TEST(Simulate, AFigureThatIsNotWholeIsAnErrorAndIsDeleted) {
  const Outcome r = run_on_a_full_disk("trivium simulate heavy_top --t-end 1 --plot motion.svg");
  EXPECT_EQ(r.exit_code, 3);
  EXPECT_NE(r.err.find("cannot write motion.svg: the figure is incomplete; is the disk full?"),
            std::string::npos)
      << r.err;
  EXPECT_FALSE(fs::exists(temporary("folder") / "motion.svg"));
}

TEST(Simulate, AKilledRunLeavesTheMotionSoFarUnderANameThatSaysSo) {
  const fs::path folder = temporary("folder");
  fs::remove_all(folder);
  fs::create_directories(folder);
  run("trivium simulate stewart_platform --t-end 1e6 --output-step 0.01 --out motion.csv & sleep 1; kill "
      "-KILL $!; "
      "wait $!",
      folder);
  ASSERT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  const fs::path left = *fs::directory_iterator(folder);
  EXPECT_TRUE(left.filename().string().starts_with("motion.csv.incomplete-")) << left;
  EXPECT_GT(csv_lines(left).size(), 10u);
}

// MALLOC_PERTURB_=B: glibc fills requested memory with the complement of the byte B, freed memory with B; 0
// switches this off
TEST(Simulate, WritesTheSameBitsWhateverTheMemoryHeldBefore) {
  const fs::path file = fresh("motion.csv");
  const json known = json::parse(run("trivium list --json").out);
  for (const std::string method : known["integrators"])
    for (const std::string formulation : known["formulations"]) {
      std::string first;
      for (const char* byte : {"0", "85", "165", "255"}) {
        const auto simulate = [&](const char* steps) {
          return run("trivium simulate spatial_slider_crank --t-end 0.3 --integrator " + method +
                         " --formulation " + formulation + steps + " --out " + file.string(),
                     std::string("/ && export MALLOC_PERTURB_=") + byte);
        };
        Outcome r = simulate(" --rtol 1e-7 --atol 1e-9");
        if (r.exit_code == 2) r = simulate(" --step 0.001");
        if (r.exit_code == 2) break;  // the method does not support the formulation
        ASSERT_EQ(r.exit_code, 0) << method << ", " << formulation << ": " << r.err;
        if (first.empty()) first = slurp(file);
        EXPECT_EQ(slurp(file), first) << method << ", " << formulation << ", " << byte;
      }
    }
}

TEST(Simulate, NamesItsColumnsAsThePageDoes) {
  const fs::path file = fresh("motion.csv");
  ASSERT_EQ(
      run("trivium simulate heavy_top --integrator rattle --step 1e-4 --t-end 1e-3 --out " + file.string())
          .exit_code,
      0);
  const std::string page = slurp(TRIVIUM_SCENES_DIR "/../../docs/simulating.md");
  std::string columns;
  for (const char* column : {"t",      "top.x",   "top.y",         "top.z",         "top.e0",       "top.e1",
                             "top.e2", "top.e3",  "top.vx",        "top.vy",        "top.vz",       "top.wx",
                             "top.wy", "top.wz",  "tip.fx",        "tip.fy",        "tip.fz",       "tip.tx",
                             "tip.ty", "tip.tz",  "lambda[0]",     "lambda[1]",     "lambda[2]",    "energy",
                             "phi",    "phi_dot", "raw_lambda[0]", "raw_lambda[1]", "raw_lambda[2]"})
    columns += (columns.empty() ? "" : ",") + std::string(column);
  const std::string csv = slurp(file);
  EXPECT_EQ(csv.substr(0, csv.find('\n')), columns);
  for (const char* shown :
       {"| `t` |", "| `BODY.x` `.y` `.z` |", "| `BODY.e0` ... `.e3` |", "| `BODY.vx` `.vy` `.vz` |",
        "| `BODY.wx` `.wy` `.wz` |", "| `JOINT.fx` ... `.tz` |", "| `lambda[k]` |", "| `energy` |",
        "| `phi`, `phi_dot` |", "| `raw_lambda[k]` |"})
    EXPECT_NE(page.find(shown), std::string::npos) << shown;
}

// the file ends with the last state, also if that lies between two outputs
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
  // a bead moves to the other end of its spring: at length 0 the spring force has no direction
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

// without constraints the error can name no row, and squares of the state overflow
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

// the method itself would only report a failure of forces or rows, not its cause
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
  EXPECT_NE(r.err.find("warning: steps ended near"), std::string::npos) << r.err;
  EXPECT_GE(json::parse(r.out)["singular_positions"].size(), 1u);
}

// a newline in a name would end gnuplot's string, and gnuplot would execute the rest of the name
TEST(Simulate, NamesOfASceneAreTextInItsFigure) {
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) GTEST_SKIP() << "no gnuplot";
  const fs::path file = fresh("motion.svg"), made = fresh("made");
  const std::string scene =
      temporary_scene("named.json", R"({"trivium": 1, "name": "x'\nsystem('touch )" + made.string() +
                                        R"(')\n", "bodies": [{"name": "b`touch )" + made.string() +
                                        R"(`\n", "mass": 1, "inertia": [1, 1, 1], "position": [0, 0, 0]}]})");
  const Outcome r = run("trivium simulate " + scene + " --t-end 1 --output-step 0.1 --plot " + file.string());
  EXPECT_EQ(r.exit_code, 0) << r.err;  // a body at rest gives an empty figure, but no error
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

TEST(Simulate, GoesOnFromWhereAnotherRunEndedToTheSameBits) {
  const fs::path half = fresh("half.json"), rest = fresh("rest.csv"), whole = fresh("whole.csv");
  const std::string how = " --formulation r-epsilon --integrator radau5 --step 0.002 ";
  EXPECT_EQ(
      run("trivium simulate spatial_slider_crank --t-end 0.1 --save-end " + half.string() + how).exit_code,
      0);
  EXPECT_EQ(run("trivium simulate " + half.string() + " --t-end 0.2 --out " + rest.string() + how).exit_code,
            0);
  EXPECT_EQ(run("trivium simulate spatial_slider_crank --t-end 0.2 --out " + whole.string() + how).exit_code,
            0);
  EXPECT_EQ(csv_lines(rest).back(), csv_lines(whole).back());
  EXPECT_EQ(csv_lines(rest)[1][0], "0.10000000000000001");
  // every other command accepts the file as a scene, at the time of its state
  const Outcome solved = run("trivium solve " + half.string() + " --json");
  ASSERT_EQ(solved.exit_code, 0) << solved.err;
  EXPECT_EQ(json::parse(solved.out)["t"], 0.1);
}

TEST(Simulate, RefusesASavedRunThatIsNotItsScenes) {
  const fs::path file = fresh("end.json");
  EXPECT_EQ(run("trivium simulate heavy_top --t-end 0.1 --save-end " + file.string()).exit_code, 0);
  const Outcome early = run("trivium simulate " + file.string() + " --t 0 --t-end 1");
  EXPECT_EQ(early.exit_code, 2);
  EXPECT_NE(early.err.find(
                "the saved run cannot be continued: the state is taken at t = 0; without the key \"saved\""),
            std::string::npos)
      << early.err;
  json moved = json::parse(slurp(file));
  moved["bodies"][0]["position"][0] = moved["bodies"][0]["position"][0].get<double>() + 0.1;
  const Outcome by_hand =
      run("trivium simulate " + temporary_scene("by_hand.json", moved.dump()) + " --t-end 1");
  EXPECT_EQ(by_hand.exit_code, 2);
  EXPECT_NE(by_hand.err.find("the file was changed; remove its key \"saved\""), std::string::npos)
      << by_hand.err;
  json scene = json::parse(slurp(file));
  scene["saved"]["y"].push_back(1);
  const std::string longer = temporary_scene("longer.json", scene.dump());
  EXPECT_EQ(run("trivium simulate " + longer + " --t-end 1").exit_code, 2);
  // another formulation ignores the saved run and starts from the bodies
  EXPECT_EQ(run("trivium simulate " + longer + " --t-end 0.2 --formulation r-p").exit_code, 0);
}

}  // namespace
}  // namespace trivium::test
