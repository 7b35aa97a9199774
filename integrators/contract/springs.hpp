#pragma once
/// Springs and dampers, each by its stiffness and damping, for methods of several stages. The Newton matrix
/// of one stage has their resistance by that stage's shares only; the method solves for the coupling of the
/// stages with one unknown per spring. A model may omit its springs from Newton's matrix, so that the
/// iteration finds their forces; springs() is then 0.

#include <concepts>

#include "integrators/contract/newton_matrix.hpp"

namespace trivium::integrators {

///   springs              the number of springs in Newton's matrix
///   spring_constants     their stiffness [N/m, N m] and damping [N s/m, N m s]
///   solve                from (factors, at, left, rows, slack, x, mu, stretch): the `solve` of
///                        HasNewtonMatrix, where a spring resists only the part of its stretch by x that
///                        exceeds its slack; also returns the stretch of every spring by x
template <class System>
concept HasSprings = HasNewtonMatrix<System> &&
    requires(System& system, const typename System::Evaluation& at, const typename System::Factors& factors,
             const StateVector<typename System::Scalar>& v, StateVector<typename System::Scalar>& changed) {
  { system.springs() } -> std::convertible_to<int>;
  system.spring_constants(changed, changed);
  system.solve(factors, at, v, v, v, changed, changed, changed);
};

}  // namespace trivium::integrators
