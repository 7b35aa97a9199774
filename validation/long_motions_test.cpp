/// Energy and constraint violation after a hundred thousand periods.

#include "validation/testing/catalogue_motion.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::Motion;

// The pendulum of benchmark A01 with a hundred steps per period.
TEST(Rattle, KeepsTheEnergyOfAHundredThousandPeriods) {
  SimulationOptions options;
  options.integrator = "rattle";
  options.step = 0.025;
  options.end = 250;
  const Motion some(catalogue_scene("a01_pendulum"), options);
  options.end = 250000;
  const Motion all(catalogue_scene("a01_pendulum"), options);
  EXPECT_LE(all.report.unaccounted_energy, 1.1 * some.report.unaccounted_energy);
  EXPECT_LE(all.report.phi, 1e-13);
  EXPECT_LE(all.report.phi_dot, 1e-12);
}

}  // namespace
}  // namespace trivium
