/// Example: a user-written integration method (classical_runge_kutta.hpp). Fails if the method breaks a law
/// that its entry promises, or if a motion in any formulation differs by more than 1e-6 m from the motion by
/// dopri5. This limit is chosen by experiment for the step size 1e-3 s.
///
///   own_method_moves SCENE...

#include <fmt/format.h>
#include <base/raise.hpp>
#include <formulations/formulation_list.hpp>
#include <integrators/method_laws.hpp>
#include <mechanism/model.hpp>
#include <scenes/format/scene_file.hpp>
#include <scenes/make_mechanism.hpp>
#include <simulation/simulate.hpp>

#include "classical_runge_kutta.hpp"

using namespace trivium;

namespace {

bool keeps_its_laws() {
  const auto broken = integrators::broken_laws(classical_runge_kutta());
  for (const BrokenLaw& law : broken) fmt::print("broken: {}\n", law.text());
  return broken.empty();
}

bool has_the_same_motion(const Model<double>& model, const std::string& formulation) {
  SimulationOptions options{.formulation = formulation, .integrator = "dopri5", .end = 0.5};
  Samples expected, moved;
  simulate(model, options, expected);
  options.own_method = classical_runge_kutta();
  options.step = 1e-3;
  simulate(model, options, moved);
  double apart = 0;
  for (std::size_t b = 0; b < moved.all.back().state.pose.size(); ++b)
    raise(apart, (moved.all.back().state.pose[b].r - expected.all.back().state.pose[b].r).norm());
  fmt::print("{} in {} by rk4 to t = 0.5: {:.1e} m from dopri5\n", model.mechanism.name, formulation, apart);
  return apart <= 1e-6;
}

}  // namespace

int main(int count, char** arguments) {
  bool passed = count > 1 && keeps_its_laws();
  for (int k = 1; k < count; ++k) {
    const auto model = make_model<double>(scenes::read_scene_file(arguments[k]));
    for (const std::string& formulation : formulation_names())
      passed = has_the_same_motion(model, formulation) && passed;
  }
  return passed ? 0 : 1;
}
