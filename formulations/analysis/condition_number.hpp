#pragma once
/// kappa: the condition number of the equilibrated S = Phi M^-1 Phi^T, E^-1 S E^-1 with E = diag(S)^(1/2),
/// over its nonzero singular values. Rounding of lambda grows with it; the bound on lambda's difference
/// between two formulations is 100 u kappa (lambda_bound in comparison.hpp).

#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// Of S = W^T W with W = L^-1 Phi^T E^-1 [6 nb x nc], where the mass metric is L L^T, and the rank of its
/// rows; 1 where the rank is 0.
double condition_number(const MatrixX<double>& W, int rank);

}  // namespace trivium
