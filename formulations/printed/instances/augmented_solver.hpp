#pragma once
/// The instantiations in augmented_solver_*.cpp: every formulation of formulation_list.hpp in one Scalar.

#include "formulations/formulation_list.hpp"
#include "formulations/printed/augmented_solver_impl.hpp"
#include "formulations/printed/redundant_multipliers_impl.hpp"

#define TRIVIUM_AUGMENTED_EQUATIONS_IN(F, S) template class AugmentedEquations<F<S>>;
#define TRIVIUM_AUGMENTED_EQUATIONS(S)                    \
  namespace trivium {                                     \
  TRIVIUM_FORMULATIONS(TRIVIUM_AUGMENTED_EQUATIONS_IN, S) \
  }

#define TRIVIUM_AUGMENTED_SOLVER_IN(F, S) \
  template class AugmentedSolver<F<S>>;   \
  template PhysicalSolution<S> solve_printed<F<S>>(const Model<S>&, const RowAnalysis&, const ChartOptions&);

#define TRIVIUM_AUGMENTED_SOLVER(S)                    \
  TRIVIUM_AUGMENTED_EQUATIONS(S)                       \
  namespace trivium {                                  \
  template class RedundantMultipliers<S>;              \
  TRIVIUM_FORMULATIONS(TRIVIUM_AUGMENTED_SOLVER_IN, S) \
  }
