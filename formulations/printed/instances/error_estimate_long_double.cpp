#include "bodies/numbers/quad.hpp"
#include "formulations/formulation_list.hpp"
#include "formulations/printed/error_estimate_impl.hpp"

namespace trivium {
template ErrorEstimate estimate_error(const AugmentedSolver<ROmega<long double>>&,
                                      const VectorX<long double>&,
                                      const AugmentedEquations<ROmega<NextPrecisionT<long double>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<RP<long double>>&, const VectorX<long double>&,
                                      const AugmentedEquations<RP<NextPrecisionT<long double>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<REpsilon<long double>>&,
                                      const VectorX<long double>&,
                                      const AugmentedEquations<REpsilon<NextPrecisionT<long double>>>&);
template ErrorEstimate estimate_error(
    const AugmentedSolver<REpsilonOmegaFirst<long double>>&, const VectorX<long double>&,
    const AugmentedEquations<REpsilonOmegaFirst<NextPrecisionT<long double>>>&);
}  // namespace trivium
