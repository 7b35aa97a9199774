#pragma once
/// The instantiations in error_estimate_*.cpp: every formulation of formulation_list.hpp in one Scalar, with
/// the next precision for the estimate.

#include "formulations/formulation_list.hpp"
#include "formulations/printed/error_estimate_impl.hpp"

#define TRIVIUM_ERROR_ESTIMATE_IN(F, S)                                                  \
  template ErrorEstimate estimate_error(const AugmentedSolver<F<S>>&, const VectorX<S>&, \
                                        const AugmentedEquations<F<NextPrecisionT<S>>>&);

#define TRIVIUM_ERROR_ESTIMATE(S)                    \
  namespace trivium {                                \
  TRIVIUM_FORMULATIONS(TRIVIUM_ERROR_ESTIMATE_IN, S) \
  }
