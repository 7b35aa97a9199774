/// `trivium generate`, run as a user does.

#include "trivium/command/testing/run_program.hpp"

namespace trivium::test {
namespace {

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
  EXPECT_NE(r.err.find("N: found 2; accepted: at least 3 bars for a ring"), std::string::npos) << r.err;
}

}  // namespace
}  // namespace trivium::test
