/// `trivium compare`, run as a user does.

#include "trivium/command/testing/run_program.hpp"

namespace trivium::test {
namespace {

TEST(Compare, SaysHowFarLambdaIsApartAlongAMotionAndAtItsStates) {
  const fs::path folder = temporary("out");
  fs::remove_all(folder);
  const Outcome r = run("trivium compare spatial_slider_crank --t-end 1 --out " + folder.string());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_NE(r.out.find("\nlambda along the motion: holds; "), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("\nlambda at one state: holds; "), std::string::npos) << r.out;
  const std::string csv = slurp(folder / "compare.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 102);
  EXPECT_TRUE(csv.starts_with("t,lambda,lambda_bound,amplification,")) << csv.substr(0, 60);
  for (const char* formulation : {"r-omega", "r-p", "r-epsilon", "r-epsilon-omega-first"})
    EXPECT_EQ(slurp(folder / (std::string(formulation) + ".csv")).substr(0, 12), "t,crank.x,cr")
        << formulation;
}

TEST(Compare, ShowsNoDifferenceOfLambdaWhereNoMultiplierIsUnique) {
  const Outcome r = run("trivium compare door --t-end 0.1");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const std::size_t first = r.out.find("\n0 ");
  ASSERT_NE(first, std::string::npos) << r.out;
  const std::string line = r.out.substr(first + 1, r.out.find('\n', first + 1) - first - 1);
  EXPECT_NE(line.find("none"), std::string::npos) << line;
}

TEST(Compare, SaysTheSameInJson) {
  const Outcome r = run("trivium compare heavy_top --t-end 0.5 --formulations r-omega,r-p --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json c = json::parse(r.out);
  EXPECT_TRUE(c["holds_along"]);
  EXPECT_TRUE(c["holds_at_states"]);
  ASSERT_EQ(c["runs"].size(), 2u);
  EXPECT_EQ(c["runs"][1]["formulation"], "r-p");
  EXPECT_GT(c["runs"][1]["steps"], 10);
  EXPECT_EQ(c["outputs"].size(), 101u);
  EXPECT_GE(c["outputs"].back()["lambda_bound"], c["outputs"].back()["lambda"]);
}

TEST(Compare, LeavesOutWhatDoesNotGoWithTheMethodAndSaysSo) {
  const Outcome r = run("trivium compare heavy_top --integrator rattle --step 0.0005 --t-end 0.1 --json");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(json::parse(r.out)["runs"].size(), 2u);
  EXPECT_EQ(r.err,
            "warning: the formulation r-p is left out: the method rattle does not support it\n"
            "warning: the formulation r-epsilon is left out: the method rattle does not support it\n");
}

TEST(Compare, RefusesWhatCannotBeCompared) {
  const Outcome one = run("trivium compare heavy_top --formulations r-p");
  EXPECT_EQ(one.exit_code, 2);
  EXPECT_NE(one.err.find("only one formulation to compare; accepted: at least two of r-omega, "),
            std::string::npos)
      << one.err;
  const Outcome slip = run("trivium compare heavy_top --formulations r-p,r-omga");
  EXPECT_EQ(slip.exit_code, 2);
  EXPECT_NE(slip.err.find("did you mean \"r-omega\"?"), std::string::npos) << slip.err;
  const Outcome file = run("trivium compare heavy_top --out " + temporary_scene("no_folder", "x"));
  EXPECT_EQ(file.exit_code, 2);
  EXPECT_NE(file.err.find("is not a folder; accepted: a folder"), std::string::npos) << file.err;
}

TEST(Compare, ARunThatFailsEndsWithTheSolversExitCode) {
  const Outcome r =
      run("trivium compare flyball_governor --integrator rkf78 --step 0.01 --t-end 0.1 --output-step 0.1");
  EXPECT_EQ(r.exit_code, 3);
  EXPECT_NE(r.err.find("error: flyball_governor: r-omega: "), std::string::npos) << r.err;
  EXPECT_NE(r.out.find("failed"), std::string::npos) << r.out;
}

TEST(Compare, DrawsWhatItCompared) {
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not installed";
  const fs::path folder = temporary("out");
  fs::remove_all(folder);
  const Outcome r =
      run("trivium compare spatial_slider_crank --t-end 0.5 --out " + folder.string() + " --plot");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_NE(slurp(folder / "compare.svg").find("bound of lambda"), std::string::npos);
}

/// A motion written by the program itself, which takes the place of a motion of another code.
fs::path other_motion(const std::string& name) {
  const fs::path file = fresh(name);
  EXPECT_EQ(run("trivium simulate spatial_slider_crank --formulation r-p --integrator radau5 --t-end 1 "
                "--output-step 0.1 "
                "--out " +
                file.string())
                .exit_code,
            0);
  return file;
}

/// The text with the first `word` replaced by `other`.
std::string with(std::string text, const std::string& word, const std::string& other) {
  text.replace(text.find(word), word.size(), other);
  return text;
}

TEST(CompareAgainst, AMotionOfAnotherCodeAgreesColumnByColumn) {
  const Outcome r =
      run("trivium compare spatial_slider_crank --json --against " + other_motion("other.csv").string());
  ASSERT_EQ(r.exit_code, 0) << r.err << r.out;
  const json c = json::parse(r.out);
  EXPECT_TRUE(c["holds"]);
  EXPECT_EQ(c["times"], 11);
  EXPECT_EQ(c["unknown_columns"].size(), 17u);  // the 17 columns raw_lambda are not compared
  EXPECT_EQ(c["columns"].size(), 39 + 4 * 6 + 17 + 3u);
  for (const json& column : c["columns"])
    if (column.contains("bound")) {
      EXPECT_LE(column["difference"], column["bound"]) << column["column"];
    }
}

TEST(CompareAgainst, NamesOfItsOwnAreMapped) {
  const std::string text = with(with(slurp(other_motion("other.csv")), "t,", "Time,"), "rod.x", "X of rod");
  const std::string file = temporary_scene("mapped.csv", text);
  const Outcome r =
      run("trivium compare spatial_slider_crank --formulations r-omega --json --map Time=t --map 'X of "
          "rod=rod.x' "
          "--against " +
          file);
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json columns = json::parse(r.out)["columns"];
  EXPECT_TRUE(std::any_of(columns.begin(), columns.end(),
                          [](const json& c) { return c["column"] == "rod.x" && c["theirs"] == "X of rod"; }));
  const Outcome unmapped = run("trivium compare spatial_slider_crank --against " + file);
  EXPECT_EQ(unmapped.exit_code, 2);
  EXPECT_NE(unmapped.err.find("; accepted: one named t, or --map NAME=t"), std::string::npos);
  const Outcome slip = run("trivium compare spatial_slider_crank --map Tim=t --against " + file);
  EXPECT_EQ(slip.exit_code, 2);
  EXPECT_NE(slip.err.find("has no column \"Tim\"; accepted: Time, crank.x"), std::string::npos) << slip.err;
}

TEST(CompareAgainst, ANumberThatIsOffExceedsItsBound) {
  const std::string file =
      temporary_scene("off.csv", "t,rod.x\n0,0.15\n0.25,0.15\n0.6,0.15\n");  // unevenly spaced times
  const Outcome r = run("trivium compare spatial_slider_crank --against " + file);
  EXPECT_EQ(r.exit_code, 1) << r.err;
  EXPECT_NE(r.out.find("1 of 1 column EXCEED their bounds"), std::string::npos) << r.out;
}

TEST(CompareAgainst, ABodyThatTurnsAboutTheOriginIsJudgedAsWell) {
  const std::string file = temporary_scene("garbage.csv", "t,body.x,body.e0\n0,5,1\n1,99,-3\n2,-1e6,7\n");
  const Outcome r = run("trivium compare dzhanibekov --against " + file);
  EXPECT_EQ(r.exit_code, 1) << r.out;
  EXPECT_NE(r.out.find("2 of 2 columns EXCEED their bounds"), std::string::npos) << r.out;
}

TEST(CompareAgainst, AFileWithoutAColumnThatHasABoundIsRefused) {
  const std::string file = temporary_scene("violations.csv", "t,phi,phi_dot\n0,0,5\n1,0,5\n");
  const Outcome r = run("trivium compare heavy_top --against " + file);
  EXPECT_EQ(r.exit_code, 2) << r.out;
  EXPECT_NE(r.err.find("has no column with a bound"), std::string::npos) << r.err;
}

TEST(CompareAgainst, WithGivenStepsTheOtherCodeIsAllowedErrorsOfItsOwn) {
  const Outcome r = run("trivium compare spatial_slider_crank --step 0.001 --against " +
                        other_motion("stepped.csv").string());
  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
}

TEST(CompareAgainst, WhatIsNoMotionIsRefusedByItsPlace) {
  const auto refusal = [](const std::string& text) {
    const Outcome r =
        run("trivium compare spatial_slider_crank --against " + temporary_scene("bad.csv", text));
    EXPECT_EQ(r.exit_code, 2) << r.out;
    return r.err;
  };
  EXPECT_NE(refusal("t,rod.x\n0,0\n1,nan\n").find("line 3, rod.x: found \"nan\"; accepted: a finite number"),
            std::string::npos);
  EXPECT_NE(refusal("t,rod.x\n0,0\n0,1\n").find("t = 0 after t = 0; accepted: ascending times"),
            std::string::npos);
  EXPECT_NE(refusal("t,rod.x\n0,0\n1\n").find("line 3: 1 fields; accepted: 2"), std::string::npos);
  EXPECT_NE(refusal("t,rood.x\n0,0\n1,1\n").find("no known column name among t, rood.x"), std::string::npos);
  EXPECT_NE(refusal("").find("0 lines"), std::string::npos);
  EXPECT_NE(refusal("t,rod.x\n-1,0\n1,1\n").find("begins at t = -1, before the scene's state"),
            std::string::npos);
}

}  // namespace
}  // namespace trivium::test
