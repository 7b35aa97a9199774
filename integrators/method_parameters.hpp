#pragma once
/// The parameters that some methods let a caller choose. Which method has which parameter is checked where
/// the method is made (integrators/methods.hpp).

#include <optional>

namespace trivium::integrators {

/// What some methods let one choose; absent: the default that is named.
struct MethodParameters {
  std::optional<int> order = {};   ///< of bdf, 1 to 5: 2; of arkode-erk, 2 to 8, and arkode-dirk, 2 to 5: 5
  std::optional<double> rho = {};  ///< of generalized-alpha, in [0, 1]: 0.8, the spectral radius at infinity
  std::optional<double> alpha = {};  ///< of hht, in [-1/3, 0]: -0.2
  std::optional<bool> full_newton =
      {};                ///< of Newton's methods of our own: a matrix every iteration, not every step
  bool projects = true;  ///< whether states are projected, of cvode-bdf, which does so within its steps
};

}  // namespace trivium::integrators
