/// Motions of mechanisms with redundant rows, by every method: rows in a file with few digits, and rows that
/// take over from each other.

#include <cmath>
#include <string>
#include <vector>

#include "scenes/testing/scene_builders.hpp"
#include "validation/testing/catalogue_motion.hpp"
#include "validation/testing/every_method.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::formulations_of, test::Motion, test::options_for, test::tight;

class Redundant : public testing::TestWithParam<integrators::MethodInfo> {};

scenes::Vector3 rounded(const scenes::Vector3& x) {
  const auto digits = [](double number) { return std::round(1e10 * number) / 1e10; };
  return {digits(x[0]), digits(x[1]), digits(x[2])};
}

/// The scene with lengths, axes and velocities rounded to ten decimals, as in a file that a person edits.
scenes::Scene rounded(scenes::Scene scene) {
  for (scenes::Body& body : scene.bodies) {
    body.position = rounded(body.position);
    body.velocity = rounded(body.velocity);
    body.angular_velocity = rounded(body.angular_velocity);
  }
  for (scenes::Constraint& joint : scene.constraints)
    for (auto* side : {&joint.i, &joint.j})
      for (auto* vector : {&side->point, &side->axis})
        if (*vector) *vector = rounded(**vector);
  return scene;
}

// No position satisfies all rows to more than ten digits. Those that are not needed are left as they are.
TEST_P(Redundant, RowsOfFewDigitsAreNoObstacle) {
  for (const char* name : {"door", "four_bar", "parallelogram"}) {
    const scenes::Scene scene = catalogue_scene(name);
    const Motion exact(scene, tight("r-omega", "rkf78", 0.3, 1e-12));
    for (const std::string& formulation : formulations_of(GetParam())) {
      const Motion motion(rounded(scene), options_for(GetParam(), formulation, 0.3));
      EXPECT_LE(apart(motion, exact), 1e-5) << name << ", " << formulation;
      EXPECT_LE(motion.report.phi, 2e-9) << name << ", " << formulation;
    }
  }
}

// The third crank holds the coupler where the other two and the coupler lie in a line. There a row of the
// second crank's joint is dependent, and a row of the third takes over: no singular position.
TEST_P(Redundant, RowsTakeOverFromEachOther) {
  const scenes::Scene scene = catalogue_scene("parallelogram");
  const Motion exact(scene, tight("r-omega", "rkf78", 7, 1e-12));
  for (const std::string& formulation : formulations_of(GetParam())) {
    const Motion motion(scene, options_for(GetParam(), formulation, 7));
    EXPECT_LE(apart(motion, exact), 3e-3) << formulation;
    EXPECT_LE(motion.report.phi, 1e-10) << formulation;
    EXPECT_TRUE(motion.report.passages.empty()) << formulation;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Redundant, testing::ValuesIn(integrators::methods()),
                         test::method_in_a_name);

// The estimate of Fehlberg 7(8) does not see a singular position between its first and its last stages.
TEST(FlatParallelogram, IsFollowedByRkf78InREpsilon) {
  const scenes::Scene scene = test::hard_scene("flat_par");
  for (const double rtol : {1e-8, 5e-9, 2e-9, 5e-10}) {
    const Motion motion(scene, tight("r-epsilon", "rkf78", 6, rtol));
    const Vector3<double> exact(0.5 * std::cos(1 + 3 * 6.0), 0.5 * std::sin(1 + 3 * 6.0), 0);
    EXPECT_LE((motion.end().state.pose[0].r - exact).norm(), 1e4 * rtol) << rtol;
  }
}

}  // namespace
}  // namespace trivium
