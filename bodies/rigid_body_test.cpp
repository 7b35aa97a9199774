/// Motion of points, wrenches, kinetic energy and the check of inertias.

#include "bodies/rigid_body.hpp"

#include "bodies/inertia.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"

namespace trivium {
namespace {

using test::distance, test::Random;

BodyMotion<Quad> random_motion(Random& random) {
  return {random.vector<Quad, 3>(), random.vector<Quad, 3>(),
          rotation_matrix(random.euler_parameters<Quad>()), random.vector<Quad, 3>()};
}

TEST(BodyMotion, PointVelocityIsTheDerivativeOfThePoint) {
  Random random(4);
  for (int n = 0; n < 50; ++n) {
    const BodyMotion<Quad> motion = random_motion(random);
    const Vector3<Quad> s = random.vector<Quad, 3>();
    const Quad h(1e-11);
    const auto moved = [&](const Quad& t) {
      BodyMotion<Quad> m = motion;
      m.r += t * motion.r_dot;
      m.A = motion.A * rotation_matrix(exponential_parameters<Quad>(t * motion.omega_bar));
      return m.point(s);
    };
    EXPECT_LE(distance((moved(h) - moved(-h)) / (2 * h), motion.point_velocity(s)), 1e-20);
  }
}

TEST(Wrench, PowerOfAForceIsForceTimesVelocityOfItsPoint) {
  Random random(5);
  for (int n = 0; n < 50; ++n) {
    const BodyMotion<Quad> motion = random_motion(random);
    const Vector3<Quad> s = random.vector<Quad, 3>(), force = random.vector<Quad, 3>();
    Wrench<Quad> wrench;
    wrench.add_force(force, motion.A, s);
    const Quad power = wrench.F.dot(motion.r_dot) + wrench.n_bar.dot(motion.omega_bar);
    EXPECT_LE(std::abs(static_cast<double>(Quad(power - force.dot(motion.point_velocity(s))))), 1e-32);
  }
}

TEST(Wrench, ForcesAdd) {
  Random random(6);
  const Matrix3<Quad> A = rotation_matrix(random.euler_parameters<Quad>());
  const Vector3<Quad> s = random.vector<Quad, 3>(), a = random.vector<Quad, 3>(),
                      b = random.vector<Quad, 3>();
  Wrench<Quad> both, sum;
  both.add_force(a, A, s);
  both.add_force(b, A, s);
  sum.add_force(a + b, A, s);
  EXPECT_LE(distance(both.F, sum.F) + distance(both.n_bar, sum.n_bar), 1e-32);
}

TEST(KineticEnergy, OfARodIsTheSumOverItsMass) {
  // thin rod along x: Jyy = Jzz = m l^2 / 12. The midpoint rule with 10^4 pieces has an error of order 1e-8.
  const double m = 3, l = 2;
  const RigidBody<double> rod{m, Vector3<double>(0, m * l * l / 12, m * l * l / 12).asDiagonal()};
  const Twist<double> twist{{0.3, -0.2, 0.5}, {0.7, 1.1, -0.4}};
  double sum = 0;
  const int pieces = 10000;
  for (int k = 0; k < pieces; ++k) {
    const Vector3<double> s(l * ((k + 0.5) / pieces - 0.5), 0, 0);
    sum += m / pieces * (twist.r_dot + twist.omega_bar.cross(s)).squaredNorm() / 2;
  }
  EXPECT_NEAR(kinetic_energy(rod, twist), sum, 1e-7);
}

Eigen::Matrix3d turned(const Vector3<double>& moments) {
  const Eigen::Matrix3d A = rotation_matrix(Random(7).euler_parameters<double>());
  return A * moments.asDiagonal() * A.transpose();
}

TEST(InertiaCheck, AcceptsWhatABodyCanHave) {
  for (const Vector3<double>& moments :
       {Vector3<double>(1, 1, 1), Vector3<double>(1, 2, 2.9), Vector3<double>(1, 2, 3),
        Vector3<double>(0, 2, 2), Vector3<double>(0, 0, 0)}) {
    const InertiaCheck check = check_inertia(turned(moments));
    EXPECT_TRUE(check.physical()) << moments.transpose();
    EXPECT_LE(distance(check.principal_moments, moments), 1e-14);  // ascending, in any frame
  }
}

TEST(InertiaCheck, NamesWhatIsViolated) {
  const InertiaCheck negative = check_inertia(turned({-0.1, 1, 1}));
  EXPECT_FALSE(negative.positive_semidefinite);
  EXPECT_TRUE(negative.symmetric);
  EXPECT_FALSE(negative.physical());

  const InertiaCheck thin = check_inertia(turned({1, 2, 3.01}));
  EXPECT_FALSE(thin.triangle_inequality);
  EXPECT_TRUE(thin.positive_semidefinite && thin.symmetric);
  EXPECT_FALSE(thin.physical());

  Eigen::Matrix3d skewed = turned({1, 2, 2.5});
  skewed(0, 1) += 1e-6;
  const InertiaCheck skew = check_inertia(skewed);
  EXPECT_FALSE(skew.symmetric);
  EXPECT_TRUE(skew.positive_semidefinite && skew.triangle_inequality);
  EXPECT_FALSE(skew.physical());
}

TEST(InertiaCheck, ToleratesRoundingOnly) {
  EXPECT_TRUE(check_inertia(turned({1, 2, 3 + 1e-13})).physical());
  EXPECT_FALSE(check_inertia(turned({1, 2, 3 + 1e-10})).physical());
}

}  // namespace
}  // namespace trivium
