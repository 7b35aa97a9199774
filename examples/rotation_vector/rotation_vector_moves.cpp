/// A formulation from outside beside those of the library: lambda of every scene, and motions of the first.
///   rotation_vector_moves SCENE...

#include <fmt/format.h>
#include <base/raise.hpp>
#include <formulations/contract/laws.hpp>
#include <formulations/contract/reduced_to_rotation.hpp>
#include <formulations/equations_of_motion_impl.hpp>
#include <formulations/printed/augmented_solver_impl.hpp>
#include <formulations/printed/error_estimate_impl.hpp>
#include <formulations/side_by_side_impl.hpp>
#include <formulations/structured/acceleration_solver_impl.hpp>
#include <scenes/format/scene_file.hpp>
#include <scenes/make_mechanism.hpp>
#include <simulation/simulate_impl.hpp>

#include "rotation_vector.hpp"

using namespace trivium;

namespace {

using Mine = RotationVector<double>;

/// The largest distance between bodies [m] at the end of two motions.
double apart(const MotionSample& one, const MotionSample& other) {
  double largest = 0;
  for (std::size_t b = 0; b < one.state.pose.size(); ++b)
    raise(largest, (one.state.pose[b].r - other.state.pose[b].r).norm());
  return largest;
}

/// The laws of the contract, of the printed equations and of what is made of them.
bool keeps_its_laws() {
  auto broken = broken_laws<Mine>();
  for (BrokenLaw& law : broken_laws<WholeFormulation<Mine>>()) broken.push_back(law);
  for (const BrokenLaw& law : broken) fmt::print("broken: {}\n", law.text());
  return broken.empty();
}

/// What lambda_invariance asks, of one more formulation.
bool has_the_same_lambda(const Model<double>& model) {
  const auto all = side_by_side<AllFormulations::With<RotationVector>>(model, analyse_rows(model));
  const FormulationResult<double>& mine = all.formulations.back();
  if (!mine.error.empty()) throw ModelError(mine.error);
  const double difference = all.discrepancy().lambda;
  fmt::print("{}: lambda of {} formulations, {} among them, differs by {:.1e}; bound {:.1e}\n",
             model.mechanism.name, all.formulations.size(), mine.name, difference, all.lambda_bound());
  return difference <= all.lambda_bound();
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

/// To rounding: what moves is the rotation itself, in all of them.
bool moves(const Model<double>& model) {
  return has_the_same_motion(model, "dopri5", {}, 1e-12) && has_the_same_motion(model, "radau5", {}, 1e-12) &&
         has_the_same_motion(model, "generalized-alpha", 1e-3, 1e-12);
}

}  // namespace

int main(int count, char** arguments) {
  bool passed = count > 1 && keeps_its_laws();
  for (int k = 1; k < count; ++k) {
    const Model<double> model = make_model<double>(scenes::read_scene_file(arguments[k]));
    passed = has_the_same_lambda(model) && passed;
    if (k == 1) passed = moves(model) && passed;
  }
  return passed ? 0 : 1;
}
