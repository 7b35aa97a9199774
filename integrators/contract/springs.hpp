#pragma once
/// Springs and dampers, each by its stiffness and damping, for methods of several stages. In the Newton
/// matrix of a stage a spring resists the motion of this stage alone. The method solves for the coupling of
/// the stages, with one unknown per spring and stage. A model may leave its springs out of Newton's matrix:
/// the iteration then finds their forces, and springs() is 0.

#include <concepts>

#include "integrators/contract/newton_matrix.hpp"

namespace trivium::integrators {

///   springs              the number of springs in Newton's matrix
///   spring_constants     per spring the stiffness [N/m, N m/rad] and the damping [N s/m, N m s/rad]
///   solve                from (factors, at, left, rows, slack, x, mu, stretch): the `solve` of
///                        HasNewtonMatrix for springs with slack. The solution x of this call stretches a
///                        spring by its gradient times x. The spring resists only the part of the stretch
///                        beyond its slack, a given number per spring: its force is (gamma' damping + beta'
///                        stiffness) (stretch - slack). Sets `stretch` to the stretch of every spring. Slack
///                        and stretch have the unit of the gradient times x, such as m/s^2 where x is a
///                        change of v'
template <class System>
concept HasSprings = HasNewtonMatrix<System> &&
    requires(System& system, const typename System::Evaluation& at, const typename System::Factors& factors,
             const StateVector<typename System::Scalar>& v, StateVector<typename System::Scalar>& changed) {
  { system.springs() } -> std::convertible_to<int>;
  system.spring_constants(changed, changed);
  system.solve(factors, at, v, v, v, changed, changed, changed);
};

}  // namespace trivium::integrators
