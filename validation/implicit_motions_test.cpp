/// Motions by implicit and symplectic methods, in every formulation.

#include <array>
#include <cmath>

#include "scenes/testing/scene_builders.hpp"
#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::Motion, test::tight;

SimulationOptions stepping(const std::string& formulation, const std::string& method, double end,
                           double step) {
  SimulationOptions options;
  options.formulation = formulation;
  options.integrator = method;
  options.end = end;
  options.step = step;
  return options;
}

/// Largest distance of a body between the ends of two motions.
double apart(const Motion& a, const Motion& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.end().state.pose.size(); ++k)
    largest = std::max(largest, (a.end().state.pose[k].r - b.end().state.pose[k].r).norm());
  return largest;
}

const std::vector<std::string> general{
    "generalized-alpha", "generalized-alpha-gl2", "hht", "bdf", "radau5", "radau9"};

class Implicit : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Motions, Implicit, testing::ValuesIn(formulation_names()),
                         test::formulation_in_a_name);

// the governor's damper alone asks of an explicit method steps below 1e-3 s
TEST_P(Implicit, StepsOfAStiffGovernorAreSetByAccuracy) {
  static const Motion exact(catalogue_scene("flyball_governor"), tight("r-omega", "rkf78", 2, 1e-11));
  for (const std::string& method : general) {
    const Motion coarse(catalogue_scene("flyball_governor"), stepping(GetParam(), method, 2, 0.01));
    const Motion fine(catalogue_scene("flyball_governor"), stepping(GetParam(), method, 2, 0.005));
    EXPECT_LE(apart(fine, exact), 4e-3) << method;
    EXPECT_GE(apart(coarse, exact), 1.5 * apart(fine, exact)) << method;
    EXPECT_LE(static_cast<double>(fine.report.counters.iterations), 9.0 * 400) << method;
  }
  try {
    const Motion explicit_one(catalogue_scene("flyball_governor"), stepping(GetParam(), "dopri5", 2, 0.01));
    EXPECT_GE(apart(explicit_one, exact), 0.1);
  } catch (const std::runtime_error&) {
  }
}

TEST_P(Implicit, PositionsStayOnTheirConstraintsAndVelocitiesToTheMethodsError) {
  for (const char* name : {"spatial_slider_crank", "bricard", "four_bar", "stewart_platform"})
    for (const std::string& method : general) {
      const Motion motion(catalogue_scene(name), stepping(GetParam(), method, 0.5, 0.0025));
      EXPECT_LE(motion.report.phi, 1e-12) << name << " " << method;
      const bool is_stabilised = method.ends_with("gl2") || method.starts_with("radau");
      EXPECT_LE(motion.report.phi_dot, is_stabilised ? 1e-10 : 0.2) << name << " " << method;
    }
}

// steps of its own choice, too: few beside those of an explicit method, though its springs turn by a third of
// a radian in one
TEST_P(Implicit, RadauChoosesLongStepsInAStiffMotion) {
  static const Motion exact(catalogue_scene("flyball_governor"), tight("r-omega", "rkf78", 1, 1e-11));
  const Motion motion(catalogue_scene("flyball_governor"), tight(GetParam(), "radau5", 1, 1e-6));
  const Motion by_dopri5(catalogue_scene("flyball_governor"), tight(GetParam(), "dopri5", 1, 1e-6));
  EXPECT_LE(apart(motion, exact), 1e-5);
  EXPECT_LE(motion.report.counters.steps + motion.report.counters.rejected_steps,
            by_dopri5.report.counters.steps / 30);
  EXPECT_LE(motion.report.counters.rejected_steps, motion.report.counters.steps / 4);
  EXPECT_LE(motion.report.counters.iterations, 8 * motion.report.counters.steps);
}

// errors are weighed by what turns and by where it is, each for itself; steps are those of the same motion
// about the origin
TEST_P(Implicit, RadauIsAsAccurateFarFromTheOrigin) {
  const auto pendulum_at = [](double x) {
    scenes::Scene scene;
    scene.name = "pendulum";
    scene.bodies.push_back(test::body("bob", 1, {0.1, 0.2, 0.25}, {x + 1, 0, 0}));
    scene.constraints.push_back(test::joint(ConstraintType::revolute, "pivot",
                                            test::side(scenes::ground, {{x, 0, 0}}, {{0, 1, 0}}),
                                            test::side(0, {{-1, 0, 0}}, {{0, 1, 0}})));
    scene.effects.push_back(test::gravity());
    return scene;
  };
  const Motion exact(pendulum_at(0), tight("r-omega", "rkf78", 3, 1e-12));
  for (const double rtol : {1e-3, 1e-6}) {
    const Motion near(pendulum_at(0), tight(GetParam(), "radau5", 3, rtol)),
        far(pendulum_at(1e5), tight(GetParam(), "radau5", 3, rtol));
    const auto off = [&](const Motion& motion, double x) {
      const auto &r = motion.end().state.pose[0].r, &there = exact.end().state.pose[0].r;
      return std::hypot(r[0] - x - there[0], r[2] - there[2]);
    };
    EXPECT_LE(off(far, 1e5), 2 * off(near, 0)) << rtol;
    EXPECT_LE(off(near, 0), 10 * rtol) << rtol;
    const auto tried = [](const Motion& motion) {
      const auto& counters = motion.report.counters;
      return static_cast<double>(counters.steps + counters.rejected_steps);
    };
    EXPECT_NEAR(tried(far), tried(near), 0.1 * tried(near)) << rtol;
  }
}

// where springs hold each other, no force is left that their rounding could be measured by
TEST_P(Implicit, ABodyComesToRestOnStiffSpringsAlone) {
  scenes::Scene scene;
  scene.name = "mount";
  scene.bodies.push_back(test::body("block", 1, {0.1, 0.2, 0.15}));
  scene.bodies[0].angular_velocity = {0.1, 0.2, 3};
  scene.effects.emplace_back(scenes::Gravity{{}, {0, 0, -9.81}});
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      scenes::Vector3 on_ground{}, on_block{};
      on_ground[axis] = side;
      on_block[axis] = 0.3 * side;
      on_ground[(axis + 1) % 3] = on_block[(axis + 1) % 3] = 0.1 * side;
      scenes::SpringDamper spring;
      spring.i.point = on_ground;
      spring.j.body = 0;
      spring.j.point = on_block;
      spring.stiffness = 1e8;
      spring.damping = 1e5;
      spring.free_length = 0.7;
      scene.effects.emplace_back(spring);
    }
  for (const char* method : {"generalized-alpha", "hht", "bdf", "radau5", "radau9"}) {
    const Motion motion(scene, stepping(GetParam(), method, 0.5, 1e-3));
    EXPECT_NEAR(motion.end().state.pose[0].r[2], -9.81 / 2e8, 1e-10) << method;
    EXPECT_LE(motion.end().state.twist[0].omega_bar.norm(), 1e-6) << method;
  }
  for (const char* method : {"radau5", "radau9"}) {
    const Motion chosen(scene, tight(GetParam(), method, 0.5, 1e-9));
    EXPECT_NEAR(chosen.end().state.pose[0].r[2], -9.81 / 2e8, 1e-10) << method;
    EXPECT_LE(chosen.report.counters.rejected_steps, chosen.report.counters.steps / 4) << method;
  }
}

// an explicit method would need some 10 000 steps of what is here one
TEST_P(Implicit, BackwardDifferencesBeginInAStiffMotionAsTheyGoOn) {
  const scenes::Scene scene = test::sprung_wheel(0.2, 1, 1e6, 1e6);
  for (int order = 1; order <= 5; ++order) {
    auto options = stepping(GetParam(), "bdf", 0.02, 1e-3);
    options.parameters.order = order;
    const Motion motion(scene, options);
    EXPECT_LE(motion.end().state.twist[0].omega_bar.norm(), 1e-6) << order;
    EXPECT_LE(motion.report.counters.right_sides, 200) << order;
  }
}

// bodies without rows of their own, too
TEST_P(Implicit, RadauKeepsEulerParametersUnit) {
  for (const char* method : {"radau5", "radau9"}) {
    const Motion motion(catalogue_scene("dzhanibekov"), tight(GetParam(), method, 5, 1e-2));
    EXPECT_LE(motion.report.normalisation, 1e-14) << method;
  }
}

// the shift is least in M alone where the stages' matrices have one share of dampers
TEST_P(Implicit, RadauIsOfItsOrderWhereDampersAre) {
  const scenes::Scene scene = catalogue_scene("stewart_platform");
  const auto errors = [&](const Motion& motion, const Motion& exact) {
    const auto &a = motion.end(), &b = exact.end();
    const auto apart = [&](const auto& part) {
      double largest = 0;
      for (std::size_t body = 0; body < scene.bodies.size(); ++body)
        largest = std::max(largest, ((part(a.state, body) - part(b.state, body)) +
                                     (part(*a.state_rest, body) - part(*b.state_rest, body)))
                                        .norm());
      return largest;
    };
    return std::array{apart([](const auto& state, std::size_t body) { return state.pose[body].r; }),
                      apart([](const auto& state, std::size_t body) { return state.twist[body].r_dot; }),
                      (a.lambda - b.lambda + a.lambda_rest - b.lambda_rest).norm()};
  };
  struct Case {
    const char* method;
    int order, steps;
    double end;
  };
  for (const Case& c : {Case{"radau5", 5, 10, 0.05}, {"radau9", 9, 5, 0.1}}) {
    const Motion exact(scene, tight("r-omega", "rkf78", c.end, 1e-19), test::in_quad);
    const auto after = [&](int steps) {
      return errors(Motion(scene, stepping(GetParam(), c.method, c.end, c.end / steps), test::in_quad),
                    exact);
    };
    const auto coarse = after(c.steps), fine = after(2 * c.steps);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(std::log2(coarse[k] / fine[k]), c.order, 0.2) << c.method << " " << k;
  }
}

TEST_P(Implicit, RadauMeetsRowsAtTheEndsOfStepsToRounding) {
  for (const char* name : {"flyball_governor", "spatial_slider_crank", "bricard"}) {
    for (const char* method : {"radau5", "radau9"}) {
      const Motion motion(catalogue_scene(name), tight(GetParam(), method, 0.5, 1e-4));
      EXPECT_LE(motion.report.phi, 1e-13) << name << " " << method;
      EXPECT_LE(motion.report.phi_dot, 1e-12) << name << " " << method;
    }
  }
}

// the more, the tighter: five stages a step, but longer steps
TEST_P(Implicit, ToTightErrorsTheHigherOrderOfRadauAsksForLess) {
  static const Motion exact(catalogue_scene("flyball_governor"), tight("r-omega", "rkf78", 1, 1e-13));
  const scenes::Scene scene = catalogue_scene("flyball_governor");
  const Motion by_five(scene, tight(GetParam(), "radau5", 1, 1e-8)),
      by_nine(scene, tight(GetParam(), "radau9", 1, 1e-7));
  EXPECT_LE(apart(by_five, exact), 1e-8);
  EXPECT_LE(apart(by_nine, exact), apart(by_five, exact));
  EXPECT_LE(by_nine.report.counters.right_sides, by_five.report.counters.right_sides / 2);
}

TEST_P(Implicit, BackwardDifferencesOfLibrariesChooseLongStepsInAStiffMotion) {
  static const Motion exact(catalogue_scene("flyball_governor"), tight("r-omega", "rkf78", 1, 1e-11));
  const Motion by_dopri5(catalogue_scene("flyball_governor"), tight(GetParam(), "dopri5", 1, 1e-7));
  for (const char* method : {"cvode-bdf", "ida", "arkode-dirk"}) {
    const Motion motion(catalogue_scene("flyball_governor"), tight(GetParam(), method, 1, 1e-7));
    EXPECT_LE(apart(motion, exact), 5e-5) << method;
    EXPECT_LE(motion.report.counters.steps + motion.report.counters.rejected_steps,
              by_dopri5.report.counters.steps / 2)
        << method;
    // Newton's matrix is worth its name
    EXPECT_LE(static_cast<double>(motion.report.counters.iterations),
              method == std::string("arkode-dirk") ? 45.0 * static_cast<double>(motion.report.counters.steps)
                                                   : 5.0 * static_cast<double>(motion.report.counters.steps))
        << method;
  }
}

// one method, one step: formulations differ by its error, and less by its order
TEST_P(Implicit, LambdaOfTheFormulationsMeetsAtTheMethodsOrder) {
  const auto gap = [&](const std::string& method, double h) {
    const Motion motion(catalogue_scene("spatial_slider_crank"), stepping(GetParam(), method, 0.1, h));
    const Motion by_omega(catalogue_scene("spatial_slider_crank"), stepping("r-omega", method, 0.1, h));
    return (motion.end().lambda - by_omega.end().lambda).norm();
  };
  if (GetParam() == "r-omega") return;
  for (const char* method : {"generalized-alpha", "generalized-alpha-gl2", "bdf"}) {
    const double coarse = gap(method, 1e-3), fine = gap(method, 2.5e-4);
    EXPECT_LE(coarse, 1e-3) << method;
    EXPECT_LE(fine, coarse / 10 + 1e-10) << method;
  }
}

TEST_P(Implicit, RedundantMechanismsPassTheirSingularPositions) {
  const Motion exact(catalogue_scene("n_four_bar_2"), tight("r-omega", "dopri5", 3, 1e-10));
  for (const char* method : {"generalized-alpha", "bdf"}) {
    const Motion motion(catalogue_scene("n_four_bar_2"), stepping(GetParam(), method, 3, 0.0025));
    EXPECT_LE(apart(motion, exact), 5e-3) << method;
  }
  for (const char* method : {"radau5", "radau9"}) {
    const Motion by_radau(catalogue_scene("n_four_bar_2"), tight(GetParam(), method, 3, 1e-6));
    EXPECT_LE(apart(by_radau, exact), 1e-4) << method;
    EXPECT_LE(by_radau.report.counters.steps, 500) << method;
  }
}

TEST_P(Implicit, ChangesOfChartAndKinksRestartAMethod) {
  const Motion exact(catalogue_scene("heavy_top"), tight("r-omega", "rkf78", 0.3, 1e-11));
  for (const std::string& method : general) {
    if (method == "hht") continue;  // of order 1 here: convergence_order shows it
    SimulationOptions options = stepping(GetParam(), method, 0.3, 1e-4);
    options.parameters.order = method == "bdf" ? std::optional<int>(4) : std::nullopt;
    const Motion motion(catalogue_scene("heavy_top"), options);
    EXPECT_LE(apart(motion, exact), 2e-4) << method;
    EXPECT_EQ(motion.report.reframings > 0, motion.report.counters.restarts > 0) << method;
  }
}

TEST_P(Implicit, FullNewtonFindsTheSameMotion) {
  for (const std::string& method : general) {
    SimulationOptions options = stepping(GetParam(), method, 0.2, 0.002);
    const Motion modified(catalogue_scene("stewart_platform"), options);
    options.parameters.full_newton = true;
    const Motion full(catalogue_scene("stewart_platform"), options);
    EXPECT_LE(apart(full, modified), 1e-9) << method;
    EXPECT_GE(full.report.factorisations, modified.report.factorisations) << method;
  }
}

// stages that are reached by another way are no others, also where the method's error is not small
TEST_P(Implicit, FullNewtonFindsTheSameMotionOfRadauAtLongSteps) {
  SimulationOptions options = stepping(GetParam(), "radau9", 1, 0.025);
  const Motion modified(catalogue_scene("spatial_four_bar"), options);
  options.parameters.full_newton = true;
  EXPECT_LE(apart(Motion(catalogue_scene("spatial_four_bar"), options), modified), 1e-6);
}

// what iterations leave of a step is less in a shorter one: a thousand steps are no worse than a dozen
TEST_P(Implicit, OutputsThatCutStepsDoNotAddUpToErrorsOfRadau) {
  static const Motion exact(catalogue_scene("stewart_platform"), tight("r-omega", "rkf78", 1, 1e-12));
  for (const char* method : {"radau5", "radau9"}) {
    SimulationOptions options = tight(GetParam(), method, 1, 1e-5);
    const double few = apart(Motion(catalogue_scene("stewart_platform"), options), exact);
    options.output_step = 1e-3;
    EXPECT_LE(apart(Motion(catalogue_scene("stewart_platform"), options), exact), few) << method;
  }
}

// two methods for the work too, of dampers and drivers
TEST_P(Implicit, WorkAccountsForTheEnergy) {
  for (const char* name : {"driven_crank", "open_arm_7"})
    for (const std::string& method : general) {
      const Motion motion(catalogue_scene(name), stepping(GetParam(), method, 0.5, 0.001));
      EXPECT_GT(std::abs(motion.report.work), 1e-3) << name;
      EXPECT_LE(motion.report.unaccounted_energy, 2e-2 * (1 + motion.report.largest_kinetic))
          << name << " " << method;
    }
}

TEST(Rattle, KeepsTheEnergyBoundedAndTheConstraintsMet) {
  for (const char* name : {"a01_pendulum", "heavy_top", "bricard"}) {
    const double step = std::string(name) == "heavy_top" ? 1e-3 : 0.02;
    const Motion some(catalogue_scene(name), stepping("r-omega", "rattle", 10, step));
    const Motion more(catalogue_scene(name), stepping("r-omega", "rattle", 100, step));
    EXPECT_LE(more.report.unaccounted_energy, 1.5 * some.report.unaccounted_energy) << name;
    EXPECT_LE(more.report.phi, 1e-13) << name;
    EXPECT_LE(more.report.phi_dot, 1e-11) << name;
  }
}

TEST(Rattle, IsRefusedWhereTheMassMatrixDependsOnThePosition) {
  for (const char* formulation : {"r-p", "r-epsilon"})
    EXPECT_THROW(Motion(catalogue_scene("heavy_top"), stepping(formulation, "rattle", 0.1, 0.001)),
                 integrators::UsageError);
}

class Libraries : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Motions, Libraries, testing::ValuesIn(formulation_names()),
                         test::formulation_in_a_name);

const std::vector<std::string> of_sundials{"cvode-adams", "cvode-bdf", "arkode-erk", "arkode-dirk", "ida"};

TEST_P(Libraries, MotionsFollowTheToleranceOnTheirConstraints) {
  for (const auto& [name, end] : {std::pair("spatial_slider_crank", 0.5),
                                  {"bricard", 2.0},
                                  {"stewart_platform", 0.5},
                                  {"welded_rotor", 1.0}}) {
    const Motion exact(catalogue_scene(name), tight("r-omega", "rkf78", end, 1e-12));
    for (const std::string& method : of_sundials) {
      double before = 1;
      for (const double rtol : {1e-5, 1e-9}) {
        const Motion motion(catalogue_scene(name), tight(GetParam(), method, end, rtol));
        EXPECT_LE(apart(motion, exact), 1e3 * rtol) << name << " " << method;
        EXPECT_LE(apart(motion, exact), before) << name << " " << method;
        EXPECT_LE(motion.report.phi, 1e-13) << name << " " << method;
        EXPECT_LE(motion.report.phi_dot, 1e-12) << name << " " << method;
        EXPECT_LE(motion.report.normalisation, 1e-14) << name << " " << method;
        before = apart(motion, exact) / 10;
      }
    }
  }
}

// they step over outputs: these cost no steps, and are as exact as the end
TEST_P(Libraries, OutputsBetweenStepsAreOfTheMethodsOwnAccuracy) {
  SimulationOptions options = tight("r-omega", "rkf78", 1, 1e-12);
  options.output_step = 0.01;
  const Motion exact(catalogue_scene("double_pendulum"), options);
  for (const char* method : {"cvode-adams", "cvode-bdf", "ida"}) {
    options = tight(GetParam(), method, 1, 1e-8);
    const Motion alone(catalogue_scene("double_pendulum"), options);
    options.output_step = 0.01;
    const Motion motion(catalogue_scene("double_pendulum"), options);
    ASSERT_EQ(motion.samples.size(), exact.samples.size());
    double largest = 0;
    for (std::size_t k = 0; k < exact.samples.size(); ++k) {
      EXPECT_EQ(motion.samples[k].state.t, exact.samples[k].state.t);
      EXPECT_LE(motion.samples[k].phi, 1e-13) << method << " " << k;
      for (std::size_t b = 0; b < 2; ++b)
        largest =
            std::max(largest, (motion.samples[k].state.pose[b].r - exact.samples[k].state.pose[b].r).norm());
    }
    EXPECT_LE(largest, 1e-6) << method;
    EXPECT_EQ(motion.report.counters.steps, alone.report.counters.steps) << method;
  }
}

TEST_P(Libraries, MultipliersOfIDAAreThoseOfTheState) {
  SimulationOptions options = tight(GetParam(), "ida", 0.5, 1e-9);
  options.output_step = 0.05;
  const Motion motion(catalogue_scene("spatial_slider_crank"), options);
  double largest = 0;
  for (const MotionSample& sample : motion.samples)
    largest = std::max(largest, sample.lambda.size() ? sample.lambda.cwiseAbs().maxCoeff() : 0.0);
  EXPECT_LE(motion.report.lambda_gap, 1e-4 * largest);
}

TEST(LibrariesUnprojected, DriftAsTheTolerancesLetThem) {
  for (const char* method : {"cvode-adams", "cvode-bdf", "arkode-erk", "arkode-dirk"}) {
    SimulationOptions options = tight("r-p", method, 2, 1e-6);
    options.projects = false;
    const Motion motion(catalogue_scene("double_pendulum"), options);
    EXPECT_GE(motion.report.phi, 1e-10) << method;
    EXPECT_LE(motion.report.phi, 1e-3) << method;
  }
}

}  // namespace
}  // namespace trivium
