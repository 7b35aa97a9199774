#pragma once
/// Springs and dampers one by one, for methods of several stages. In Newton's matrix of a stage they resist
/// by the stage's own shares alone; what stages do to each other is solved for in the springs' few numbers. A
/// model may leave its springs to the iteration, and have none here.

#include <concepts>

#include "integrators/contract/newton_matrix.hpp"

namespace trivium::integrators {

///   springs              how many springs resist in Newton's matrix
///   spring_constants     their stiffness and damping
///   solve                from (factors, at, left, rows, slack, x, mu, stretch): as without springs, where
///                        they resist only what x stretches them by beyond a slack; and by how much it does
template <class System>
concept HasSprings = HasNewtonMatrix<System> &&
    requires(System& system, const typename System::Evaluation& at, const typename System::Factors& factors,
             const StateVector<typename System::Scalar>& v, StateVector<typename System::Scalar>& changed) {
  { system.springs() } -> std::convertible_to<int>;
  system.spring_constants(changed, changed);
  system.solve(factors, at, v, v, v, changed, changed, changed);
};

}  // namespace trivium::integrators
