#pragma once
/// The optional parameters of methods. Whether a method accepts a parameter is checked where the method is
/// made (integrators/methods.hpp).

#include <optional>

namespace trivium::integrators {

/// An absent parameter takes the default that is named in its comment.
struct MethodParameters {
  std::optional<int> order =
      {};  ///< bdf: 1 to 5, default 2; arkode-erk: 2 to 6 or 8, arkode-dirk: 2 to 5, default 5
  std::optional<double> rho = {};  ///< generalized-alpha: spectral radius at infinity in [0, 1], default 0.8
  std::optional<double> alpha = {};  ///< hht: in [-1/3, 0], default -0.2
  std::optional<bool> full_newton =
      {};                ///< implicit methods but SUNDIALS': factor in every iteration, not once per step
  bool projects = true;  ///< cvode-bdf: whether it projects states within its steps
};

}  // namespace trivium::integrators
