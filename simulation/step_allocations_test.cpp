/// After the first steps, a step allocates no memory. Allocations are counted at malloc, which serves both
/// Eigen and operator new. Methods of other libraries (Odeint, ARKODE) are not tested.

#include <gtest/gtest.h>

#include "base/testing/counted_allocations.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "integrators/contract/any_system.hpp"
#include "integrators/methods.hpp"
#include "integrators/projection_iteration.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "simulation/system/constrained_equations.hpp"

namespace trivium {
namespace {

/// The number of allocations in 20 steps, projections and accepted states, after 10 steps that do not count.
template <class F>
long long allocations_of(const std::string& scene, const std::string& name) {
  const auto model = make_model<double>(test::catalogue_scene(scene));
  ConstrainedEquations<F> equations(model.mechanism, model.state);
  integrators::SystemAdapter<ConstrainedEquations<F>> system(equations);
  const auto method = integrators::make_method<double>(name, integrators::Steps::given, {});
  const bool is_projected = !integrators::find_method(name)->meets_constraints;
  integrators::ProjectionIteration<integrators::AnySystem<double>> project;
  integrators::ProjectionReport<double> report;
  VectorX<double> y = equations.start();
  double t = 0;
  long long before = 0;
  for (int step = 1; step <= 30; ++step) {
    if (step == 11) before = test::allocations();
    method->step(system, t, y, step * 1e-3);
    if (is_projected) project(system, t, y, report);
    system.accept_state(t, y);
  }
  return test::allocations() - before;
}

TEST(Allocations, AreSeenWhereThereAreAny) {
  const long long before = test::allocations();
  VectorX<double> numbers(100);
  numbers.setZero();
  EXPECT_GT(test::allocations(), before);
}

TEST(Allocations, NoStepMakesAny) {
  for (const char* method : {"generalized-alpha", "generalized-alpha-gl2", "hht", "radau5", "radau9", "bdf"})
    for (const char* scene : {"triple_pendulum", "four_bar", "flyball_governor"}) {
      EXPECT_EQ(allocations_of<ROmega<double>>(scene, method), 0) << method << " " << scene;
      EXPECT_EQ(allocations_of<RP<double>>(scene, method), 0) << method << " " << scene;
    }
  for (const char* scene : {"triple_pendulum", "four_bar"})
    for (const char* method : {"hem4", "hedop5", "rattle", "rattle4"})
      EXPECT_EQ(allocations_of<ROmega<double>>(scene, method), 0) << method << " " << scene;
}

}  // namespace
}  // namespace trivium
