#pragma once
/// What the units of error_estimate_<scalar>.cpp compile: every formulation in one Scalar, judged by the next
/// precision. The formulations are those of formulation_list.hpp.

#include "formulations/formulation_list.hpp"
#include "formulations/printed/error_estimate_impl.hpp"

#define TRIVIUM_ERROR_ESTIMATE_IN(F, S)                                                  \
  template ErrorEstimate estimate_error(const AugmentedSolver<F<S>>&, const VectorX<S>&, \
                                        const AugmentedEquations<F<NextPrecisionT<S>>>&);

#define TRIVIUM_ERROR_ESTIMATE(S)                    \
  namespace trivium {                                \
  TRIVIUM_FORMULATIONS(TRIVIUM_ERROR_ESTIMATE_IN, S) \
  }
