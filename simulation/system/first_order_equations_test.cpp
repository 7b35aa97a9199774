/// The first-order equations of every formulation describe the same motion, constraints and energies.

#include "simulation/system/first_order_equations.hpp"

#include <Eigen/LU>
#include <numbers>

#include "base/raise.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "constraints/constraint_row.hpp"
#include "formulations/testing/printed_and_structured.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::distance, test::Random;
using StateVector = VectorX<double>;

template <class F>
class FirstOrder : public testing::Test {};
TYPED_TEST_SUITE(FirstOrder, test::AllFormulations<double>, test::FormulationNames);

template <class F>
FirstOrderEquations<F> form_of(const scenes::Scene& scene, const FirstOrderOptions& options = {}) {
  return {make_mechanism<double>(scene), make_state<double>(scene), options};
}

/// The start with random changes up to `size`, so that constraints are violated; internal rows still hold.
template <class F>
StateVector moved(const FirstOrderEquations<F>& form, double size, std::uint64_t seed = 7) {
  Random random(seed);
  StateVector y = form.start();
  for (double& x : y) x += random.uniform(-size, size);
  form.normalise(y);
  return y;
}

/// Phi and Phi' of every row, evaluated directly in r-omega at the pose and twist of y.
template <class F>
struct ByRows {
  MechanismState<double> state;
  EquationsOfMotion<ROmega<double>> eom;
  VectorX<double> phi, phi_dot;

  ByRows(FirstOrderEquations<F>& form, const StateVector& y)
      : state(form.to_mechanism_state(0, y)),
        eom(equations_of_motion<ROmega<double>>(
            form.mechanism(), to_coordinates<ROmega<double>>(form.mechanism(), state, {}), 0.0)),
        phi(eom.nc()),
        phi_dot(eom.nc()) {
    for (int k = 0; k < eom.nc(); ++k) {
      const auto& row = eom.row[k];
      const auto &i = eom.body[eom.pair[k].i], &j = eom.body[eom.pair[k].j];
      phi[k] = row.phi;
      phi_dot[k] = row.r_i.dot(i.r_dot) + row.rot_i.dot(i.omega_bar) + row.r_j.dot(j.r_dot) +
                   row.rot_j.dot(j.omega_bar) - row.nu;
    }
  }
  double largest(const FirstOrderEquations<F>& form, const VectorX<double>& values) const {
    double worst = 0;
    for (int k = 0; k < values.size(); ++k)
      raise(worst, std::abs(values[k]) / row_scale(form.mechanism().rows[k], 0.0));
    return worst;
  }
};

TYPED_TEST(FirstOrder, StartsFromThePoseAndTwistOfTheScene) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const scenes::Scene scene = test::varied_scene(seed);
    auto form = form_of<TypeParam>(scene);
    const auto expected = make_state<double>(scene), found = form.to_mechanism_state(0, form.start());
    for (int b = 0; b < form.nb(); ++b) {
      EXPECT_LE(distance(found.pose[b].r, expected.pose[b].r), 0);
      EXPECT_LE(distance(rotation_matrix(found.pose[b].p), rotation_matrix(expected.pose[b].p)), 1e-14);
      EXPECT_LE(distance(found.twist[b].r_dot, expected.twist[b].r_dot), 0);
      EXPECT_LE(distance(found.twist[b].omega_bar, expected.twist[b].omega_bar), 1e-13);
    }
  }
}

// central differences along y': poses change by the twists, twists by the accelerations of r-omega
TYPED_TEST(FirstOrder, MovesAlongItsTwistAndAccelerations) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const scenes::Scene scene = test::varied_scene(seed);
    auto form = form_of<TypeParam>(scene);
    const StateVector y = form.start();
    StateVector y_dot;
    form.derivative(0, y, y_dot);
    const auto state = make_state<double>(scene);
    const auto mechanism = make_mechanism<double>(scene);
    AccelerationSolver<ROmega<double>> solver(mechanism);
    solver.solve(to_coordinates<ROmega<double>>(mechanism, state, {}), 0);
    constexpr double h = 1e-6;
    const auto after = form.to_mechanism_state(h, y + h * y_dot),
               before = form.to_mechanism_state(-h, y - h * y_dot);
    for (int b = 0; b < form.nb(); ++b) {
      const auto by_difference = [&](const auto& later, const auto& earlier) {
        return ((later - earlier) / (2 * h)).eval();
      };
      const Matrix3<double> A = rotation_matrix(state.pose[b].p);
      const double size = 1 + solver.r_ddot(b).norm() + solver.omega_bar_dot(b).norm();
      EXPECT_LE(distance(by_difference(after.pose[b].r, before.pose[b].r), state.twist[b].r_dot), 1e-8);
      EXPECT_LE(distance(by_difference(rotation_matrix(after.pose[b].p), rotation_matrix(before.pose[b].p)),
                         A * tilde(state.twist[b].omega_bar)),
                1e-7);
      EXPECT_LE(distance(by_difference(after.twist[b].r_dot, before.twist[b].r_dot), solver.r_ddot(b)),
                1e-7 * size);
      EXPECT_LE(distance(by_difference(after.twist[b].omega_bar, before.twist[b].omega_bar),
                         solver.omega_bar_dot(b)),
                1e-7 * size)
          << seed;
    }
  }
}

TYPED_TEST(FirstOrder, MeasuresTheViolationsOfItsRows) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    auto form = form_of<TypeParam>(test::varied_scene(seed));
    const StateVector y = moved(form, 0.1, seed);
    const ByRows rows(form, y);
    EXPECT_NEAR(form.position_violation(0, y).size, rows.largest(form, rows.phi), 1e-13);
    EXPECT_NEAR(form.velocity_violation(0, y).size, rows.largest(form, rows.phi_dot), 1e-12);
  }
}

TYPED_TEST(FirstOrder, CorrectsPositionsAndVelocitiesToTheirRows) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    auto form = form_of<TypeParam>(test::varied_scene(seed));
    StateVector y = moved(form, 1e-5, seed);
    const double before = form.position_violation(0, y).size;
    form.correct_positions(0, y, true);
    EXPECT_LE(form.position_violation(0, y).size, 1e-8 + 1e4 * before * before) << seed;
    form.correct_positions(0, y, false);
    EXPECT_LE(form.position_violation(0, y).size, 1e-11) << seed;
    form.normalise(y);
    form.correct_velocities(0, y, true);
    EXPECT_LE(form.velocity_violation(0, y).size, 1e-11) << seed;
  }
}

// the least change is orthogonal, in the mass metric, to every motion that the rows permit
TYPED_TEST(FirstOrder, CorrectsByTheLeastChangeInTheMassMetric) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const scenes::Scene scene = test::varied_scene(seed);
    auto form = form_of<TypeParam>(scene);
    const TangentSystem system = tangent_system(form.mechanism(), make_state<double>(scene));
    if (form.mechanism().nc() == 0) continue;
    Eigen::FullPivLU<MatrixX<double>> rows(system.Phi);
    rows.setThreshold(1e-9);
    if (rows.dimensionOfKernel() == 0) continue;
    const MatrixX<double> free = rows.kernel();
    StateVector y = form.start();
    Random random(seed);
    for (Eigen::Index k = StateLayout<TypeParam>::positions * form.nb(); k < form.motion_size(); ++k)
      y[k] += random.uniform();
    form.normalise(y);
    const auto before = form.to_mechanism_state(0, y);
    form.correct_velocities(0, y, true);
    const auto after = form.to_mechanism_state(0, y);
    VectorX<double> momentum(6 * form.nb());
    for (int b = 0; b < form.nb(); ++b)
      momentum.segment<6>(6 * b) << system.mass[b] * (after.twist[b].r_dot - before.twist[b].r_dot),
          system.inertia[b] * (after.twist[b].omega_bar - before.twist[b].omega_bar);
    EXPECT_LE((free.transpose() * momentum).norm(), 1e-10 * (1 + momentum.norm()) * free.norm()) << seed;
  }
}

// a small violation makes redundant rows look independent; the dependent rows of the start are kept
TYPED_TEST(FirstOrder, RedundantRowsStayRedundantWithinAStep) {
  for (const char* name : {"bricard", "parallelogram", "four_bar", "door"}) {
    auto form = form_of<TypeParam>(catalogue_scene(name));
    StateVector at_start, beside;
    form.derivative(0, form.start(), at_start);
    for (const double size : {1e-3, 1e-5, 1e-8}) {
      form.derivative(0, moved(form, size), beside);
      EXPECT_LE((beside - at_start).norm(), 300 * size * (1 + at_start.norm())) << name << " " << size;
    }
  }
}

TYPED_TEST(FirstOrder, PowerIsTheRateOfTheEnergyThatIsNotConserved) {
  for (const char* name :
       {"flyball_governor", "driven_crank", "basic_drivers", "open_arm_7", "slots_and_rods"}) {
    auto form = form_of<TypeParam>(catalogue_scene(name));
    ASSERT_TRUE(form.does_work()) << name;
    StateVector y = form.start(), y_dot;
    form.derivative(0, y, y_dot);
    constexpr double h = 1e-6;
    const double rate =
        (form.energy(h, y + h * y_dot).total() - form.energy(-h, y - h * y_dot).total()) / (2 * h);
    EXPECT_NEAR(rate, y_dot[form.motion_size()], 1e-6 * (1 + std::abs(rate))) << name;
  }
}

TYPED_TEST(FirstOrder, BaumgarteMakesViolationsADampedOscillation) {
  const Baumgarte by{3, 5};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const scenes::Scene scene = test::random_scene(seed, {.bodies = 3, .closings = 1});
    auto form = form_of<TypeParam>(scene, {{}, by});
    const StateVector y = moved(form, 1e-2, seed);
    const ByRows rows(form, y);
    auto& solver = form.solved(0, y);
    std::vector<BodyAcceleration<double, 3>> acceleration(form.nb() + 1);
    for (int b = 0; b < form.nb(); ++b) acceleration[b] = {solver.r_ddot(b), solver.omega_bar_dot(b)};
    for (int k = 0; k < rows.eom.nc(); ++k) {
      const auto [i, j] = rows.eom.pair[k];
      const double phi_ddot = row_acceleration(form.mechanism().rows[k], rows.eom.body[i], rows.eom.body[j],
                                               0.0, acceleration[i], acceleration[j]);
      EXPECT_NEAR(phi_ddot + 2 * by.alpha * rows.phi_dot[k] + by.beta * by.beta * rows.phi[k], 0, 1e-9)
          << form.mechanism().row_names[k];
    }
  }
}

TYPED_TEST(FirstOrder, AReframedBodyIsWhereItWas) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const scenes::Scene scene = test::random_scene(seed, {.bodies = 3});
    auto form = form_of<TypeParam>(scene);
    StateVector y = form.start();
    // body 1 gets theta = 0.1, where sin(theta) is below the reframing distance of 0.3
    if constexpr (TypeParam::orientation_size == 3) y[StateLayout<TypeParam>::positions + 4] = 0.1;
    const auto before = form.to_mechanism_state(0, y);
    const VectorX<double> lambda = form.solved(0, y).lambda();
    const bool changed = form.accept_state(0, y);
    EXPECT_EQ(changed, TypeParam::orientation_size == 3);
    EXPECT_EQ(form.reframings(), changed ? 1 : 0);
    const auto after = form.to_mechanism_state(0, y);
    for (int b = 0; b < form.nb(); ++b) {
      EXPECT_LE(distance(rotation_matrix(after.pose[b].p), rotation_matrix(before.pose[b].p)), 1e-14);
      EXPECT_LE(distance(after.twist[b].omega_bar, before.twist[b].omega_bar), 1e-12);
    }
    EXPECT_LE(distance(form.solved(0, y).lambda(), lambda), 1e-9 * (1 + lambda.norm()));
    EXPECT_FALSE(form.accept_state(0, y));
  }
}

TYPED_TEST(FirstOrder, ABodyWhoseAnglesLoseFullTurnsIsWhereItWas) {
  constexpr bool has_angles = TypeParam::orientation_size == 3;
  for (const bool reframes : {true, false}) {
    const scenes::Scene scene = test::random_scene(5, {.bodies = 3});
    auto form = form_of<TypeParam>(scene, {{{}, reframes}, {}});
    StateVector y = form.start();
    EXPECT_FALSE(form.accept_state(0, y));
    const StateVector start = y;
    for (const int turns : {101, -1000}) {
      if (has_angles) y[StateLayout<TypeParam>::positions + 3] += turns * 2 * std::numbers::pi;
      EXPECT_EQ(form.accept_state(0, y), has_angles);
      EXPECT_LE(distance(y, start), 1e-12);
      EXPECT_EQ(form.reframings(), 0);
    }
  }
}

TEST(ARawChart, IsSuspectedNearItsSingularity) {
  using F = REpsilon<double>;
  const scenes::Scene scene = test::random_scene(3, {.bodies = 2});
  auto form = form_of<F>(scene, {{{}, false}, {}});
  StateVector y = form.start();
  EXPECT_EQ(form.diagnose(0, y, 0), "");
  y[StateLayout<F>::positions + 4] = 1e-3;
  EXPECT_NE(form.diagnose(0, y, 0).find("\"" + scene.bodies[1].name + "\""), std::string::npos)
      << form.diagnose(0, y, 0);
  EXPECT_FALSE(form.accept_state(0, y));
}

}  // namespace
}  // namespace trivium
