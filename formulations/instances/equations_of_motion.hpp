#pragma once
/// What the units of equations_of_motion_<scalar>.cpp compile: every formulation in one Scalar. The list of
/// formulations stands here as a macro, as explicit instantiations cannot be generated from
/// formulation_list.hpp.

#include "formulations/equations_of_motion_impl.hpp"
#include "formulations/formulation_list.hpp"

#define TRIVIUM_EQUATIONS_OF_MOTION_IN(F, S)                                                          \
  template std::vector<BodyState<F<S>>> to_coordinates(const Mechanism<S>&, const MechanismState<S>&, \
                                                       const ChartOptions&);                          \
  template std::vector<F<S>::Kinematics> body_kinematics(const std::vector<BodyState<F<S>>>&);        \
  template EquationsOfMotion<F<S>> equations_of_motion(const Mechanism<S>&,                           \
                                                       const std::vector<BodyState<F<S>>>&, const S&);

#define TRIVIUM_EQUATIONS_OF_MOTION(S)                  \
  namespace trivium {                                   \
  TRIVIUM_EQUATIONS_OF_MOTION_IN(ROmega, S)             \
  TRIVIUM_EQUATIONS_OF_MOTION_IN(RP, S)                 \
  TRIVIUM_EQUATIONS_OF_MOTION_IN(REpsilon, S)           \
  TRIVIUM_EQUATIONS_OF_MOTION_IN(REpsilonOmegaFirst, S) \
  }
