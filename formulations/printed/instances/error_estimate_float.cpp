#include "bodies/numbers/scalar.hpp"
#include "formulations/formulation_list.hpp"
#include "formulations/printed/error_estimate_impl.hpp"

namespace trivium {
template ErrorEstimate estimate_error(const AugmentedSolver<ROmega<float>>&, const VectorX<float>&,
                                      const AugmentedEquations<ROmega<NextPrecisionT<float>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<RP<float>>&, const VectorX<float>&,
                                      const AugmentedEquations<RP<NextPrecisionT<float>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<REpsilon<float>>&, const VectorX<float>&,
                                      const AugmentedEquations<REpsilon<NextPrecisionT<float>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<REpsilonOmegaFirst<float>>&,
                                      const VectorX<float>&,
                                      const AugmentedEquations<REpsilonOmegaFirst<NextPrecisionT<float>>>&);
}  // namespace trivium
