#pragma once
/// The instantiations in equations_of_motion_*.cpp: every formulation of formulation_list.hpp in one Scalar.

#include "formulations/equations_of_motion_impl.hpp"
#include "formulations/formulation_list.hpp"

#define TRIVIUM_EQUATIONS_OF_MOTION_IN(F, S)                                                          \
  template std::vector<BodyState<F<S>>> to_coordinates(const Mechanism<S>&, const MechanismState<S>&, \
                                                       const ChartOptions&);                          \
  template std::vector<F<S>::Kinematics> body_kinematics(const std::vector<BodyState<F<S>>>&);        \
  template EquationsOfMotion<F<S>> equations_of_motion(const Mechanism<S>&,                           \
                                                       const std::vector<BodyState<F<S>>>&, const S&);

#define TRIVIUM_EQUATIONS_OF_MOTION(S)                    \
  namespace trivium {                                     \
  TRIVIUM_FORMULATIONS(TRIVIUM_EQUATIONS_OF_MOTION_IN, S) \
  }
