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
  EXPECT_NE(run("trivium check " + file).out.find("not determined: too large for the dense solver"),
            std::string::npos);
}

}  // namespace
}  // namespace trivium::test
