/// The physical twin: which inertias change, and by how much.

#include "validation/simbody/physical_inertia.hpp"

#include <gtest/gtest.h>

#include "bodies/inertia.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium {
namespace {

scenes::Scene body_with(scenes::Vector3 inertia) {
  scenes::Scene scene;
  scenes::Body& body = scene.bodies.emplace_back();
  body.name = "body";
  body.mass = 3;
  body.inertia = inertia;
  body.unphysical_inertia = true;
  return scene;
}

Vector3<double> twin_moments(const scenes::Scene& scene) {
  return check_inertia(make_mechanism<double>(physical_twin(scene)).bodies[0].inertia).principal_moments;
}

TEST(PhysicalTwin, LeavesAPhysicalBodyAlone) {
  for (const scenes::Vector3 inertia : {scenes::Vector3{1, 2, 2.5}, scenes::Vector3{1, 1, 2}})
    EXPECT_EQ(physical_twin(body_with(inertia)), body_with(inertia));
}

TEST(PhysicalTwin, RaisesMomentsUntilTheTriangleInequalityHolds) {
  const Vector3<double> moments = twin_moments(body_with({1, 2, 5}));
  EXPECT_NEAR(moments[0], 1 + 2 + 0.08, 1e-12);  // J3 - J1 - J2 = 2, trace / 100 = 0.08
  EXPECT_NEAR(moments[2], 5 + 2 + 0.08, 1e-12);
}

TEST(PhysicalTwin, GivesASlenderRodAnAxialInertia) {
  const Vector3<double> moments = twin_moments(body_with({0, 2, 2}));
  EXPECT_NEAR(moments[0], 0.04, 1e-12);
}

TEST(PhysicalTwin, GivesAPointMassTheSizeOfItsReach) {
  scenes::Scene scene = body_with({0, 0, 0});
  EXPECT_NEAR(twin_moments(scene)[0], 0.03, 1e-12);
  scenes::Side& side = scene.constraints.emplace_back().j;
  side.body = 0;
  side.point = scenes::Vector3{0, 2, 0};
  EXPECT_NEAR(twin_moments(scene)[0], 3 * 4 / 100.0, 1e-12);
}

}  // namespace
}  // namespace trivium
