/// `trivium list`, run as a user does.

#include "trivium/command/testing/run_program.hpp"

namespace trivium::test {
namespace {

TEST(List, NamesScenesFormulationsJointsAndEffects) {
  const Outcome r = run("trivium list --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json l = json::parse(r.out);
  EXPECT_GE(l["scenes"].size(), 30u);
  // lower bounds, so that new types do not break the test
  EXPECT_GE(l["formulations"].size(), 4u);
  EXPECT_GE(l["constraints"].size(), 15u);
  EXPECT_GE(l["effects"].size(), 5u);
}

TEST(List, CountsBodiesInWords) {
  const Outcome r = run("trivium list");
  EXPECT_NE(r.out.find(" 1 body "), std::string::npos) << r.out;
  EXPECT_NE(r.out.find(" 3 bodies "), std::string::npos) << r.out;
  EXPECT_EQ(r.out.find(" 1 bodies"), std::string::npos) << r.out;
}

}  // namespace
}  // namespace trivium::test
