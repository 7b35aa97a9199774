/// Doubles of a file in a Scalar with a smaller range are refused with a clear message, or rounded if
/// harmless.

#include "scenes/range_checked_cast.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "bodies/numbers/quad.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

/// A change that writes a number beyond the range of float into a scene, and the expected part of the
/// message.
struct Beyond {
  const char* says;
  std::function<void(scenes::Scene&)> write;
};

scenes::Scene two_bodies() {
  scenes::Scene scene;
  scene.bodies = {test::body("a", 1), test::body("b", 2)};
  return scene;
}

const std::vector<Beyond>& beyond_float() {
  using scenes::Scene;
  const auto constraint = [](ConstraintType type, const std::function<void(scenes::Constraint&)>& write) {
    return [=](Scene& s) {
      s.constraints = {test::joint(type, "c", test::side(scenes::ground), test::side(0))};
      write(s.constraints[0]);
    };
  };
  using F = TimeFunction;
  static const std::vector<Beyond> all{
      {"body \"b\": mass 1e-60", [](Scene& s) { s.bodies[1].mass = 1e-60; }},
      {"body \"b\": mass 1e-40", [](Scene& s) { s.bodies[1].mass = 1e-40; }},  // subnormal
      {"body \"b\": mass 1e+39", [](Scene& s) { s.bodies[1].mass = 1e39; }},
      {"body \"a\": inertia 1e-60",
       [](Scene& s) {
         s.bodies[0].inertia = scenes::Vector3{1, 1, 1e-60};
       }},
      {"body \"a\": inertia 1e-60",
       [](Scene& s) {
         s.bodies[0].inertia = scenes::Matrix3{{{1e-60, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
       }},
      {"body \"a\": position 1e+39",
       [](Scene& s) {
         s.bodies[0].position = {0, 1e39, 1};
       }},
      {"body \"a\": velocity -1e+39",
       [](Scene& s) {
         s.bodies[0].velocity = {0, -1e39, 0};
       }},
      {"body \"a\": angular_velocity 1e+39",
       [](Scene& s) {
         s.bodies[0].angular_velocity = {1e39, 0, 0};
       }},
      {"body \"a\": angle 1e+39",
       [](Scene& s) {
         s.bodies[0].orientation = scenes::AxisAngle{{0, 0, 1}, 1e39};
       }},
      {"constraint \"c\": j/point 1e+39", constraint(JointType::spherical,
                                                     [](auto& c) {
                                                       c.j.point = {0, 0, 1e39};
                                                     })},
      {"constraint \"c\": i/vector 1e-60", constraint(basic_type<DP1>,
                                                      [](auto& c) {
                                                        c.i.vector = {1e-60, 0, 0};
                                                      })},
      {"constraint \"c\": direction 1e-60", constraint(basic_type<CD>,
                                                       [](auto& c) {
                                                         c.direction = {1e-60, 0, 0};
                                                       })},
      {"constraint \"c\": f 1e-60", constraint(basic_type<CD>, [](auto& c) { c.f = 1e-60; })},
      {"constraint \"c\": squared distance 1e+40",
       constraint(JointType::distance, [](auto& c) { c.distance = 1e20; })},
      {"constraint \"c\": angle 1e+39",
       constraint(JointType::rotation_driver,
                  [](auto& c) {
                    c.angle = F(F::Sum{{F(1), F(F::Sin{{F(F::Polynomial{{0, 1e39}})}})}});
                  })},
      {"effect \"/effects/0\": acceleration 1e-60",
       [](Scene& s) {
         s.effects = {Gravity<double>{"", {0, 0, 1e-60}}};
       }},
      {"effect \"pull\": force 1e+39",
       [](Scene& s) {
         s.effects = {Force<double>{"pull", 0, Vector3<double>::Zero(), {1, 2, 1e39}}};
       }},
      {"effect \"turn\": torque 1e-60",
       [](Scene& s) {
         s.effects = {Torque<double>{"turn", 0, {F(F::Harmonic{0, 1e-60, 1, 0})}}};
       }},
      {"effect \"spring\": stiffness 1e+39", [](Scene& s) {
         s.effects = {SpringDamper<double>{"spring", {0}, {1}, 1e39, 0, 0, {}}};
       }}};
  return all;
}

template <class Scalar>
void build(const scenes::Scene& scene) {
  make_mechanism<Scalar>(scene);
  make_state<Scalar>(scene);
}

TEST(Narrowing, RefusesByNameWhatTheScalarCannotHold) {
  for (const auto& [says, write] : beyond_float()) {
    scenes::Scene scene = two_bodies();
    write(scene);
    try {
      build<float>(scene);
      ADD_FAILURE() << says;
    } catch (const ModelError& error) {
      EXPECT_EQ(error.what(), std::string(says) + " is beyond the range of float; use --scalar double");
    }
  }
}

TEST(Narrowing, TakesEveryDoubleWhereTheScalarHoldsIt) {
  for (const auto& [says, write] : beyond_float()) {
    scenes::Scene scene = two_bodies();
    write(scene);
    EXPECT_NO_THROW(build<double>(scene)) << says;
    EXPECT_NO_THROW(build<Quad>(scene)) << says;
  }
}

TEST(Narrowing, RefusesATimeThatTheScalarCannotHold) {
  EXPECT_THROW(make_state<float>(two_bodies(), static_cast<float>(1e39)), ModelError);
  EXPECT_NO_THROW(make_state<double>(two_bodies(), 1e39));
}

/// A component that is the rounding error of a zero, as programs write it, must not prevent a solution in
/// float.
TEST(Narrowing, RoundsAComponentAwayBesideLargerOnes) {
  scenes::Scene scene = two_bodies();
  scene.bodies[0].velocity = {1e-48, 1, 0};
  scene.bodies[0].orientation = scenes::AxisAngle{{1e-48, 0, 1}, 1e-48};
  EXPECT_NO_THROW(build<float>(scene));
}

}  // namespace
}  // namespace trivium
