#include "bodies/numbers/real50.hpp"
#include "formulations/formulation_list.hpp"
#include "formulations/printed/error_estimate_impl.hpp"

namespace trivium {
template ErrorEstimate estimate_error(const AugmentedSolver<ROmega<Quad>>&, const VectorX<Quad>&,
                                      const AugmentedEquations<ROmega<NextPrecisionT<Quad>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<RP<Quad>>&, const VectorX<Quad>&,
                                      const AugmentedEquations<RP<NextPrecisionT<Quad>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<REpsilon<Quad>>&, const VectorX<Quad>&,
                                      const AugmentedEquations<REpsilon<NextPrecisionT<Quad>>>&);
template ErrorEstimate estimate_error(const AugmentedSolver<REpsilonOmegaFirst<Quad>>&, const VectorX<Quad>&,
                                      const AugmentedEquations<REpsilonOmegaFirst<NextPrecisionT<Quad>>>&);
}  // namespace trivium
