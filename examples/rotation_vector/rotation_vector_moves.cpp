/// Example: simulates motions in the user-written formulation r-phi (rotation_vector.hpp). Fails if r-phi
/// breaks a law of the contract, or if a motion differs from the motion in r-omega by more than rounding. The
/// multipliers are compared by rotation_vector_lambda_invariance.
///
///   rotation_vector_moves SCENE...

#include <fmt/format.h>
#include <base/raise.hpp>
#include <formulations/contract/laws.hpp>
#include <formulations/contract/reduced_to_rotation.hpp>
#include <formulations/equations_of_motion_impl.hpp>
#include <formulations/structured/acceleration_solver_impl.hpp>
#include <scenes/format/scene_file.hpp>
#include <scenes/make_mechanism.hpp>
#include <simulation/simulate_impl.hpp>

#include "rotation_vector.hpp"

using namespace trivium;

namespace {

using Mine = RotationVector<double>;

/// The largest distance [m] between corresponding centres of mass of two samples.
double apart(const MotionSample& one, const MotionSample& other) {
  double largest = 0;
  for (std::size_t b = 0; b < one.state.pose.size(); ++b)
    raise(largest, (one.state.pose[b].r - other.state.pose[b].r).norm());
  return largest;
}

/// Checks the laws of the printed equations, and of the complete formulation that is derived from them.
bool keeps_its_laws() {
  auto broken = broken_laws<Mine>();
  for (BrokenLaw& law : broken_laws<WholeFormulation<Mine>>()) broken.push_back(law);
  for (const BrokenLaw& law : broken) fmt::print("broken: {}\n", law.text());
  return broken.empty();
}

bool has_the_same_motion(const Model<double>& model, const std::string& method, std::optional<double> step,
                         double tolerance) {
  SimulationOptions options{.integrator = method, .end = 0.5, .step = step};
  Samples moved, expected;
  simulate_in<WholeFormulation<Mine>>(model, options, moved);
  simulate(model, options, expected);
  const double difference = apart(moved.all.back(), expected.all.back());
  fmt::print("{}: {} to t = {}: {:.1e} m from r-omega\n", model.mechanism.name, method, options.end,
             difference);
  return difference <= tolerance;
}

/// The motions agree to rounding: in a WholeFormulation, as in r-omega, the integrators advance the rotation
/// (p, omega_bar) and not the coordinates phi.
bool moves(const Model<double>& model) {
  return has_the_same_motion(model, "dopri5", {}, 1e-12) && has_the_same_motion(model, "radau5", {}, 1e-12) &&
         has_the_same_motion(model, "generalized-alpha", 1e-3, 1e-12);
}

}  // namespace

int main(int count, char** arguments) {
  bool passed = count > 1 && keeps_its_laws();
  for (int k = 1; k < count; ++k)
    passed = moves(make_model<double>(scenes::read_scene_file(arguments[k]))) && passed;
  return passed ? 0 : 1;
}
