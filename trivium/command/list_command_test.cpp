/// `trivium list` as a user meets it.

#include "formulations/formulation_list.hpp"
#include "scenes/format/scene_keys.hpp"
#include "trivium/command/testing/run_program.hpp"

namespace trivium::test {
namespace {

TEST(List, NamesScenesFormulationsJointsAndEffects) {
  const Outcome r = run("trivium list --json");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json l = json::parse(r.out);
  EXPECT_GE(l["scenes"].size(), 30u);
  EXPECT_EQ(l["formulations"], json(formulation_names()));
  EXPECT_EQ(l["constraints"].size(), scenes::constraint_shapes().size());
  EXPECT_EQ(l["effects"].size(), scenes::effect_shapes().size());
}

TEST(List, CountsBodiesInWords) {
  const Outcome r = run("trivium list");
  EXPECT_NE(r.out.find(" 1 body "), std::string::npos) << r.out;
  EXPECT_NE(r.out.find(" 3 bodies "), std::string::npos) << r.out;
  EXPECT_EQ(r.out.find(" 1 bodies"), std::string::npos) << r.out;
}

}  // namespace
}  // namespace trivium::test
