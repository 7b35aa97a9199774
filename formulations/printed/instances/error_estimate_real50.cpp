#include "bodies/numbers/real50.hpp"
#include "formulations/formulation_list.hpp"
#include "formulations/printed/error_estimate_impl.hpp"

namespace trivium {
template ErrorEstimate estimate_error(const AugmentedSolver<ROmega<Real50>>&, const VectorX<Real50>&,
                                      const AugmentedEquations<ROmega<NextPrecisionT<Real50>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<RP<Real50>>&, const VectorX<Real50>&,
                                      const AugmentedEquations<RP<NextPrecisionT<Real50>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<REpsilon<Real50>>&, const VectorX<Real50>&,
                                      const AugmentedEquations<REpsilon<NextPrecisionT<Real50>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<REpsilonOmegaFirst<Real50>>&,
                                      const VectorX<Real50>&,
                                      const AugmentedEquations<REpsilonOmegaFirst<NextPrecisionT<Real50>>>&);
}  // namespace trivium
