/// Is lambda the same number in every formulation of the library? The program stands in
/// validation/harness/lambda_invariance.hpp, for any list of formulations.

#include "validation/harness/lambda_invariance.hpp"

int main(int argc, char** argv) {
  return trivium::lambda_invariance(argc, argv, trivium::compared_formulations());
}
