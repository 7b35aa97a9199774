/// Example: adds the formulation r-d (directors.hpp) to those of the library and compares the multipliers
/// lambda of the printed systems of all formulations. Fails if r-d breaks a law of the contract, or if lambda
/// differs by more than the bound.
///
///   directors_lambda SCENE...

#include <fmt/format.h>
#include <formulations/contract/laws.hpp>
#include <formulations/equations_of_motion_impl.hpp>
#include <formulations/printed/augmented_solver_impl.hpp>
#include <formulations/printed/error_estimate_impl.hpp>
#include <formulations/side_by_side_impl.hpp>
#include <scenes/format/scene_file.hpp>
#include <scenes/make_mechanism.hpp>

#include "directors.hpp"

int main(int count, char** arguments) {
  using namespace trivium;
  bool passed = count > 1;
  for (const BrokenLaw& law : broken_laws<Directors<double>>()) {
    fmt::print("broken: {}\n", law.text());
    passed = false;
  }
  for (int k = 1; k < count; ++k) {
    const Model<double> model = make_model<double>(scenes::read_scene_file(arguments[k]));
    const auto all = side_by_side<AllFormulations::With<Directors>>(model, analyse_rows(model));
    all.require_solved();
    const double difference = all.discrepancy().lambda;
    fmt::print("{}: lambda of {} formulations, {} among them, differs by {:.1e}; bound {:.1e}\n",
               model.mechanism.name, all.formulations.size(), Directors<double>::name, difference,
               all.lambda_bound());
    passed = passed && difference <= all.lambda_bound();
  }
  return passed ? 0 : 1;
}
