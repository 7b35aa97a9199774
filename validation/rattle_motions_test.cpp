/// Simulations by the symplectic methods: energy, order over events, and cases where the methods are refused.

#include <cmath>

#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::apart, test::catalogue_scene, test::Motion, test::stepping, test::tight, test::wellformed_scene;

// rattle4 has substeps that go back in time. None of them may see the functions beyond the event.
TEST(Rattle, KeepsItsOrderOverEvents) {
  const scenes::Scene scene = wellformed_scene("jerked_trolley");
  const Motion exact(scene, tight("r-omega", "rkf78", 1, 1e-13));
  const auto error = [&](double h) {
    SimulationOptions options = tight("r-omega", "rattle4", 1);
    options.step = h;
    const Motion motion(scene, options);
    EXPECT_LE(motion.report.unaccounted_energy, 1e-3 * h);
    return (motion.end().state.pose[1].r - exact.end().state.pose[1].r).norm();
  };
  const double coarse = error(0.05), fine = error(0.025);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.5);
}

TEST(Rattle, WorkIsOfTheMethodsOrder) {
  const auto missing = [&](const char* method, double h) {
    SimulationOptions options = tight("r-omega", method, 1);
    options.step = h;
    return Motion(catalogue_scene("driven_crank"), options).report.unaccounted_energy;
  };
  EXPECT_NEAR(std::log2(missing("rattle", 0.01) / missing("rattle", 0.005)), 2, 0.2);
  EXPECT_NEAR(std::log2(missing("rattle4", 0.01) / missing("rattle4", 0.005)), 4, 0.2);
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

// the momentum vanishes where the pendulum turns back, and is no measure of the residual there
TEST(Rattle, RunsOnWhereABodyTurnsBack) {
  const Motion motion(catalogue_scene("simple_pendulum"), stepping("r-omega", "rattle", 2000, 0.01));
  EXPECT_EQ(motion.end().state.t, 2000);
  EXPECT_LE(motion.report.phi, 1e-13);
}

// Newton's matrix belongs to the start of a step; behind a singular position it has the wrong sign
TEST(Rattle, PassesASingularPosition) {
  const Motion motion(catalogue_scene("n_four_bar_2"), stepping("r-omega", "rattle", 2.6, 0.002));
  EXPECT_EQ(motion.end().state.t, 2.6);
  EXPECT_LE(motion.report.unaccounted_energy, 0.01);
}

// an Euler angle may pass half a turn within the step
TEST(Rattle, InterpolatesOutputsAcrossAFullTurnOfAnAngle) {
  const scenes::Scene scene = catalogue_scene("spatial_slider_crank");
  SimulationOptions options = tight("r-epsilon-omega-first", "rattle", 0.5, 1e-8);
  options.output_step = 0.025;
  EXPECT_LE(apart(Motion(scene, options), Motion(scene, tight("r-omega", "rkf78", 0.5))), 1e-5);
}

// Whatever the step: a row that is dependent at the start of a step may be independent at its end.
TEST(Rattle, PassesTheSingularPositionsOfAFlatParallelogramWithAnyStep) {
  const scenes::Scene scene = test::hard_scene("flat_par");
  for (const double step : {1e-2, 1e-3, 5e-4}) {
    const Motion motion(scene, stepping("r-omega", "rattle", 100, step));
    EXPECT_LE(motion.report.unaccounted_energy, 1e-6) << step;
    EXPECT_LE(motion.report.phi, 1e-8) << step;
    EXPECT_LE(motion.report.phi_dot, 1e-6) << step;
  }
}

// some step begins so near a singular position that a row is left out, and ends far from it
TEST(Rattle, GoesOnPassingThemForHundredsOfTurns) {
  const scenes::Scene scene = test::hard_scene("flat_par");
  for (const double step : {1e-2, 8e-3}) {
    const Motion motion(scene, stepping("r-omega", "rattle", 400, step));
    EXPECT_LE(motion.report.unaccounted_energy, 1e-4) << step;
    EXPECT_LE(motion.report.phi, 1e-5) << step;
    EXPECT_LE(motion.report.phi_dot, 1e-3) << step;
  }
}

TEST(Rattle, IsRefusedWhereTheMassMatrixDependsOnThePosition) {
  for (const char* formulation : {"r-p", "r-epsilon"})
    EXPECT_THROW(Motion(catalogue_scene("heavy_top"), stepping(formulation, "rattle", 0.1, 0.001)),
                 integrators::UsageError);
}

}  // namespace
}  // namespace trivium
