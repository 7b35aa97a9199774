/// The validation programs, run as a user does: output, messages and exit codes.

#include "trivium/command/testing/run_program.hpp"

namespace trivium::test {
namespace {

TEST(EveryValidation, RefusesAnInconsistentStart) {
  const std::string scene = moving_wrongly();
  for (const std::string& program : validations()) {
    const Outcome r = run(program + " " + scene);
    EXPECT_EQ(r.exit_code, 2) << program;
    EXPECT_NE(r.err.find("velocity: residual"), std::string::npos) << r.err;
  }
}

TEST(EveryValidation, NamesAllBadScenesBeforeItComputesAny) {
  const std::string unread = temporary_scene("not_json.json", "{"), moved = moving_wrongly();
  for (const std::string& program : validations()) {
    const Outcome r = run(program + " heavy_top " + unread + " no_such_scene " + moved);
    EXPECT_EQ(r.exit_code, 2) << program;
    EXPECT_EQ(r.out, "") << program;
    for (const std::string& source : {unread, std::string("no_such_scene"), moved})
      EXPECT_NE(r.err.find("error: " + source + ": "), std::string::npos) << program << r.err;
  }
}

TEST(EveryValidation, SolvesTheOtherScenesBesideOneThatFails) {
  const std::string scene = dead_point();
  for (const std::string& program : validations()) {
    const fs::path csv = temporary(program + ".csv");
    const Outcome r = run(program + " " + scene + " simple_pendulum --csv " + csv.string());
    EXPECT_EQ(r.exit_code, 3) << program;
    EXPECT_NE(r.out.find("ERROR"), std::string::npos) << r.out;
    EXPECT_NE(r.out.find("\nerror: " + scene + ": "), std::string::npos) << r.out;
    EXPECT_NE(r.out.find("\nsimple_pendulum "), std::string::npos) << r.out;
    const std::string table = slurp(csv);
    EXPECT_NE(table.find("\nbead_between_rods,"), std::string::npos) << table;
    EXPECT_NE(table.find("\nsimple_pendulum,"), std::string::npos) << table;
  }
}

TEST(EveryValidation, SaysInJsonWhyASceneFails) {
  const std::string scene = dead_point();
  for (const std::string& program : validations()) {
    const Outcome r = run(program + " simple_pendulum " + scene + " --json");
    EXPECT_EQ(r.exit_code, 3) << program;
    const json answer = json::parse(r.out);
    const char* list = program == "lambda_invariance"  ? "scenes"
                       : program == "precision_ladder" ? "rungs"
                                                       : "comparisons";
    int failed = 0;
    for (const json& row : answer[list]) {
      const bool fails = row["scene"] == "bead_between_rods";
      failed += fails;
      EXPECT_EQ(row["verdict"] == "ERROR", fails) << row;
      EXPECT_EQ(row.contains("error"), fails) << row;
      EXPECT_EQ(row.value("error", "").starts_with(scene + ": "), fails) << row;
    }
    EXPECT_GT(failed, 0) << program;
  }
}

TEST(EveryValidation, RefusesAFolderThatIsNotThereBeforeItReadsAScene) {
  for (const std::string& program : validations()) {
    const Outcome r = run(program + " no_such_scene --csv /no_such_folder/x.csv");
    EXPECT_EQ(r.exit_code, 2) << program;
    EXPECT_NE(r.err.find("/no_such_folder/x.csv: the folder /no_such_folder does not exist"),
              std::string::npos)
        << r.err;
    EXPECT_EQ(r.err.find("no_such_scene"), std::string::npos) << r.err;
  }
}

TEST(EveryValidation, RefusesToReplaceWhatIsNoRegularFileBeforeItReadsAScene) {
  const fs::path fifo = fresh("fifo.csv"), link = fresh("link.csv"), csv = fresh("beside.csv");
  const fs::path manifest = fs::path(csv).replace_extension(".manifest.json");
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  fs::create_symlink(fifo, link);
  fs::remove(manifest);
  ASSERT_EQ(mkfifo(manifest.c_str(), 0600), 0);
  for (const std::string& program : validations())
    for (const auto& [option, refused] : {std::pair{fifo, fifo}, {link, link}, {csv, manifest}}) {
      const Outcome r = run(program + " no_such_scene --csv " + option.string());
      EXPECT_EQ(r.exit_code, 2) << program;
      EXPECT_NE(r.err.find("\"" + refused.string() + "\" exists but is not a regular file"),
                std::string::npos)
          << r.err;
      EXPECT_EQ(r.err.find("no_such_scene"), std::string::npos) << r.err;
    }
  EXPECT_TRUE(fs::is_fifo(fifo) && fs::is_symlink(link) && fs::is_fifo(manifest) && !fs::exists(csv));
}

TEST(EveryValidation, WritesTheFileThatALinkPointsTo) {
  for (const std::string& program : validations())
    for (const bool is_there : {true, false}) {
      const fs::path csv = fresh("file.csv"), link = fresh("link.csv");
      if (is_there) std::ofstream(csv) << "old";
      fs::create_symlink(csv.filename(), link);
      const Outcome r = run(program + " simple_pendulum --csv " + link.string());
      EXPECT_EQ(r.exit_code, 0) << r.err;
      EXPECT_TRUE(fs::is_symlink(link));
      EXPECT_NE(slurp(csv).find("\nsimple_pendulum,"), std::string::npos) << slurp(csv);
    }
}

TEST(LambdaInvariance, TakesWholeNumbersAndSaysWhich) {
  for (const std::string words : {"--seed -1", "--seed 1.5", "--seed 18446744073709551616"}) {
    const Outcome r = run("lambda_invariance heavy_top " + words);
    EXPECT_EQ(r.exit_code, 2) << words;
    EXPECT_NE(r.err.find("accepted: a whole number from 0 to 18446744073709551615"), std::string::npos)
        << r.err;
  }
  const Outcome r = run("lambda_invariance --random -5");
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_NE(r.err.find("--random: found -5; accepted: a whole number from 0 to 1000000000"),
            std::string::npos)
      << r.err;
}

TEST(LambdaInvariance, HasNoDifferenceInJsonWhereNothingIsCompared) {
  const Outcome r = run("lambda_invariance four_bar heavy_top --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json answer = json::parse(r.out);
  EXPECT_EQ(answer["scenes"][0]["verdict"], "none");
  for (const json& difference : answer["scenes"][0]["difference"]) EXPECT_TRUE(difference.is_null());
  for (const json& difference : answer["scenes"][1]["difference"]) EXPECT_TRUE(difference.is_number());
}

TEST(LambdaInvariance, ARowThatCarriesNothingIsMeasuredAgainstItsNeighbours) {
  std::string legs;
  for (const char* corner : {"1, 1, 0", "-1, 1, 0", "-1, -1, 0", "1, -1, 0"})
    for (const char* c : {"0, 0, 1"})
      legs += std::string(R"({"type": "cd", "name": "leg)") + corner + R"(", "direction": [)" + c +
              R"(], "i": {"body": "ground", "point": [)" + corner +
              R"(]}, "j": {"body": "table", "point": [)" + corner + "]}},";
  const std::string scene = temporary_scene(
      "table.json",
      R"({"trivium": 1, "name": "table",
    "bodies": [{"name": "table", "mass": 1, "inertia": [1, 1.1, 1.2], "position": [0, 0, 0]}], "constraints": [)" +
          legs +
          R"({"type": "cd", "name": "x", "direction": [1, 0, 0], "i": {"body": "ground"}, "j": {"body": "table"}},
       {"type": "cd", "name": "y", "direction": [0, 1, 0], "i": {"body": "ground"}, "j": {"body": "table"}}],
    "effects": [{"type": "gravity", "acceleration": [0, 0, -9.81]}]})");
  EXPECT_EQ(run("lambda_invariance " + scene).exit_code, 0);
  EXPECT_EQ(run("trivium solve " + scene).err, "");
}

TEST(LambdaInvariance, HoldsOnAThousandRandomMechanisms) {
  const Outcome r = run("lambda_invariance --random 1000 --json");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const json answer = json::parse(r.out);
  EXPECT_TRUE(answer["passed"]);
  EXPECT_GE(answer["scenes"].size(), 1030u);
}

TEST(PrecisionLadder, HoldsOnTheCatalogue) {
  const Outcome r = run("precision_ladder --json");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  // on one scene, the difference falls with every higher precision
  double last = 1;
  const json ladder = json::parse(r.out);
  for (const json& rung : ladder["rungs"])
    if (rung["scene"] == "stewart_platform") {
      EXPECT_LT(rung["difference"], last) << rung["scalar"];
      last = rung["difference"];
    }
  EXPECT_LT(last, 1e-45);
}

}  // namespace
}  // namespace trivium::test
