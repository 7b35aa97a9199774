/// Example: the validation program lambda_invariance with the formulation r-phi added.
///
///   rotation_vector_lambda_invariance [SCENE...] [--random N] [--csv FILE] [--json]

#include <formulations/equations_of_motion_impl.hpp>
#include <formulations/printed/augmented_solver_impl.hpp>
#include <formulations/printed/error_estimate_impl.hpp>
#include <formulations/side_by_side_impl.hpp>
#include <validation/harness/lambda_invariance.hpp>

#include "rotation_vector.hpp"

int main(int argc, char** argv) {
  using namespace trivium;
  return lambda_invariance(argc, argv, compared_formulations<AllFormulations::With<RotationVector>>());
}
