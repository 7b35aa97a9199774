/// The multipliers of long chains with extreme mass ratios, compared with the same solver in quad.

#include <gtest/gtest.h>

#include "base/raise.hpp"
#include "bodies/numbers/quad.hpp"
#include "formulations/r_epsilon.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium {
namespace {

/// The largest relative difference of the multipliers of one joint, over all joints.
template <class S>
double joints_apart(const Mechanism<S>& mechanism, const VectorX<S>& lambda, const VectorX<Quad>& exact) {
  double worst = 0;
  for (const Joint<S>& joint : mechanism.joints) {
    Quad difference(0), size(0);
    for (int k = joint.first_row; k < joint.first_row + joint.rows; ++k) {
      const Quad d = Quad(lambda[k]) - exact[k];
      difference += d * d;
      size += exact[k] * exact[k];
    }
    raise(worst, std::sqrt(static_cast<double>(Quad(difference / size))));
  }
  return worst;
}

/// A chain of alternately light and heavy bars, with a heavy one at the tip.
scenes::Scene uneven_chain(int n, double ratio) {
  scenes::Scene scene = scenes::chain(n);
  for (int b = 0; b < n; ++b) {
    if ((n - b) % 2 == 0) continue;
    scene.bodies[b].mass *= ratio;
    for (double& moment : std::get<scenes::Vector3>(scene.bodies[b].inertia)) moment *= ratio;
  }
  return scene;
}

template <template <class> class F>
double error_of_lambda(const scenes::Scene& scene) {
  const auto solve = [&]<class S>(S) {
    const auto mechanism = make_mechanism<S>(scene);
    const auto state = make_state<S>(scene);
    AccelerationSolver<F<S>> solver(mechanism);
    solver.solve(to_coordinates<F<S>>(mechanism, state, {}), state.t);
    return solver.lambda();
  };
  return joints_apart(make_mechanism<double>(scene), solve(0.0), solve(Quad(0)));
}

TEST(LongChain, LambdaIsRightToTwelveDigitsAtAMassRatioOfABillion) {
  const auto scene = uneven_chain(1000, 1e9);
  EXPECT_LE(error_of_lambda<ROmega>(scene), 1e-12);
  EXPECT_LE(error_of_lambda<RP>(scene), 1e-12);
  EXPECT_LE(error_of_lambda<REpsilon>(scene), 1e-12);
}

TEST(LongChain, LambdaIsRightToTwelveDigitsWithoutAxialInertia) {
  scenes::Scene scene = scenes::chain(1000);
  for (auto& body : scene.bodies) std::get<scenes::Vector3>(body.inertia)[0] = 0;
  EXPECT_LE(error_of_lambda<ROmega>(scene), 1e-12);
  EXPECT_LE(error_of_lambda<RP>(scene), 1e-12);
  EXPECT_LE(error_of_lambda<REpsilon>(scene), 1e-12);
}

}  // namespace
}  // namespace trivium
