#pragma once
/// What the units of augmented_solver_<scalar>.cpp compile: every formulation in one Scalar. The list of
/// formulations stands here as a macro, as in equations_of_motion.hpp.

#include "formulations/formulation_list.hpp"
#include "formulations/printed/augmented_solver_impl.hpp"
#include "formulations/printed/redundant_multipliers_impl.hpp"

#define TRIVIUM_AUGMENTED_EQUATIONS(S)                      \
  namespace trivium {                                       \
  template class AugmentedEquations<ROmega<S>>;             \
  template class AugmentedEquations<RP<S>>;                 \
  template class AugmentedEquations<REpsilon<S>>;           \
  template class AugmentedEquations<REpsilonOmegaFirst<S>>; \
  }

#define TRIVIUM_AUGMENTED_SOLVER_IN(F, S) \
  template class AugmentedSolver<F<S>>;   \
  template PhysicalSolution<S> solve_printed<F<S>>(const Model<S>&, const RowAnalysis&, const ChartOptions&);

#define TRIVIUM_AUGMENTED_SOLVER(S)                  \
  TRIVIUM_AUGMENTED_EQUATIONS(S)                     \
  namespace trivium {                                \
  template class RedundantMultipliers<S>;            \
  TRIVIUM_AUGMENTED_SOLVER_IN(ROmega, S)             \
  TRIVIUM_AUGMENTED_SOLVER_IN(RP, S)                 \
  TRIVIUM_AUGMENTED_SOLVER_IN(REpsilon, S)           \
  TRIVIUM_AUGMENTED_SOLVER_IN(REpsilonOmegaFirst, S) \
  }
