#include "bodies/numbers/scalar.hpp"
#include "formulations/formulation_list.hpp"
#include "formulations/printed/error_estimate_impl.hpp"

namespace trivium {
template ErrorEstimate estimate_error(const AugmentedSolver<ROmega<double>>&, const VectorX<double>&,
                                      const AugmentedEquations<ROmega<NextPrecisionT<double>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<RP<double>>&, const VectorX<double>&,
                                      const AugmentedEquations<RP<NextPrecisionT<double>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<REpsilon<double>>&, const VectorX<double>&,
                                      const AugmentedEquations<REpsilon<NextPrecisionT<double>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<REpsilonOmegaFirst<double>>&,
                                      const VectorX<double>&,
                                      const AugmentedEquations<REpsilonOmegaFirst<NextPrecisionT<double>>>&);
}  // namespace trivium
