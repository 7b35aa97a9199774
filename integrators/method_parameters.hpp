#pragma once
/// The optional parameters of methods. Whether a method accepts a parameter is checked where the method is
/// made (integrators/methods.hpp).

#include <optional>

namespace trivium::integrators {

/// An absent parameter takes the default that is named in its comment.
struct MethodParameters {
  /// bdf: 1 to 5, default 2; arkode-erk: 2 to 6 or 8, default 5; arkode-dirk: 2 to 5, default 5
  std::optional<int> order = {};
  /// generalized-alpha and generalized-alpha-gl2: spectral radius at infinity in [0, 1], default 0.8;
  /// generalized-alpha with chosen steps: in [0, 0.95]
  std::optional<double> rho = {};
  std::optional<double> alpha = {};  ///< hht: in [-1/3, 0], with chosen steps in [-1/3, -0.05]; default -0.2
  /// the implicit methods except those of SUNDIALS: whether to factor Newton's matrix in every iteration,
  /// default false
  std::optional<bool> full_newton = {};
  bool projects = true;  ///< cvode-bdf: whether it projects states within its steps as well
  /// rkf78 with chosen steps: whether loads or drivers are functions of time (fehlberg_control.hpp)
  bool depends_on_time = false;
};

}  // namespace trivium::integrators
