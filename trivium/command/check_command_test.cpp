/// `trivium check`, run as a user does.

#include "trivium/command/testing/run_program.hpp"

namespace trivium::test {
namespace {

TEST(Check, ReportsRankRedundancyAndSparsity) {
  const Outcome r = run("trivium check n_four_bar_40 --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json c = json::parse(r.out);
  EXPECT_EQ(c["rank"], 485);
  EXPECT_EQ(c["dependent"].size(), 120u);
  for (const json& matrix : c["augmented_matrix"]) EXPECT_LT(matrix["percent"], 3.0) << matrix["formulation"];
}

// three points that miss a straight line by 3e-8 m: the tolerance decides the rank
TEST(Check, FindsTheRankByTheGivenTolerance) {
  const std::string scene = temporary_scene("three.json", R"({"trivium": 1, "name": "three",
    "bodies": [{"name": "b", "mass": 1, "inertia": [0.1, 0.2, 0.15], "position": [1, 0, 0]}],
    "constraints": [
      {"type": "spherical", "name": "s0", "i": {"body": "ground"}, "j": {"body": "b", "point": [-1, 0, 0]}},
      {"type": "spherical", "name": "s1", "i": {"body": "ground", "point": [0, 0, 1]},
       "j": {"body": "b", "point": [-1, 0, 1]}},
      {"type": "spherical", "name": "s2", "i": {"body": "ground", "point": [0, 3e-8, 2]},
       "j": {"body": "b", "point": [-1, 3e-8, 2]}}], "effects": []})");
  const Outcome standard = run("trivium check " + scene);
  EXPECT_NE(standard.out.find("rows, rank          9, 5"), std::string::npos) << standard.out;
  EXPECT_NE(standard.err.find("set the rank tolerance below 7"), std::string::npos) << standard.err;
  const Outcome finer = run("trivium check --rank-tolerance 1e-9 " + scene);
  EXPECT_NE(finer.out.find("rows, rank          9, 6"), std::string::npos) << finer.out;
  // a simulation accepts no tolerance below 1e-8, and so does not advise one
  const Outcome moving = run("trivium simulate --t-end 0.01 " + scene);
  EXPECT_NE(moving.err.find("is left out by a narrow margin"), std::string::npos) << moving.err;
  EXPECT_EQ(moving.err.find("set the rank tolerance"), std::string::npos) << moving.err;
  const Outcome wrong = run("trivium check --rank-tolerance 0.1 " + scene);
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("accepted: a number from 1e-14 to 0.0001"), std::string::npos) << wrong.err;
}

// kappa needs a dense matrix; larger scenes get their rank from the structured solver
TEST(Check, ReportsAllButTheConditionOfALargeScene) {
  const std::string file = temporary("tree.json").string();
  ASSERT_EQ(run("trivium generate tree 1000 --out " + file).exit_code, 0);
  const Outcome r = run("trivium check " + file + " --json");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.err, "");
  const json c = json::parse(r.out);
  EXPECT_EQ(c["nb"], 1000);
  EXPECT_EQ(c["solver"], "structured");
  EXPECT_TRUE(c["consistent"]);
  EXPECT_EQ(c["rank"], c["nc"]);
  EXPECT_FALSE(c.contains("condition"));
  EXPECT_NE(
      run("trivium check " + file).out.find("not determined: the scene is too large for the dense solver"),
      std::string::npos);
}

}  // namespace
}  // namespace trivium::test
