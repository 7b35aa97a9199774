#pragma once
/// kappa: the condition number of the equilibrated Schur complement E^-1 S E^-1, with S = Phi M^-1 Phi^T and
/// E = diag(S)^(1/2), over its nonzero singular values. Rounding errors of lambda grow with kappa. The bound
/// on the difference of lambda between two formulations is 100 u kappa (lambda_bound in comparison.hpp).

#include "bodies/numbers/vectors.hpp"

namespace trivium {

/// kappa [-] from `W` = L^-1 Phi^T E^-1 [6 nb x nc], where the mass metric is L L^T. (In row_norms.hpp, W
/// does not contain E^-1.) kappa is the largest over the rank-th largest eigenvalue of W^T W; 1 if the rank
/// is 0. kappa is at most 1e16, since smaller eigenvalues are rounding errors of the largest.
double condition_number(const MatrixX<double>& W, int rank);

}  // namespace trivium
