#pragma once
/// The two constants of Baumgarte's stabilisation. Constraint violations then decay as a damped oscillation
/// (J. Baumgarte, Comput. Methods Appl. Mech. Engrg. 1 (1972) 1-16).

namespace trivium {

/// Phi'' + 2 alpha Phi' + beta^2 Phi = 0 is imposed instead of Phi'' = 0.
struct Baumgarte {
  double alpha = 0, beta = 0;  ///< [1/s]
};

}  // namespace trivium
