/// Question: is lambda the same number in every formulation of the library? Method and criterion are
/// described in validation/harness/lambda_invariance.hpp, which contains the program for any list of
/// formulations.

#include "validation/harness/lambda_invariance.hpp"

int main(int argc, char** argv) {
  return trivium::lambda_invariance(argc, argv, trivium::compared_formulations());
}
