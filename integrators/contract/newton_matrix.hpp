#pragma once
/// Newton's matrix of an implicit step, from M, Phi_q, and the stiffness K and damping C of springs:
///
///   [ M + gamma' C + beta' K   Phi_q^T ] [ x  ]   [ left ]
///   [ Phi_q                    0       ] [ mu ] = [ rows ]
///
/// gamma' = dv/dv' [s] and beta' = dq/dv' [s^2] are the derivatives of v and q by v' within the step
/// (Shares). Their primes are part of the names and mean no derivative by time. The factors of this matrix
/// are a value: a method may keep several at the same time, and for as long as it needs them.

#include <concepts>

#include "integrators/contract/residual.hpp"

namespace trivium::integrators {

/// The derivatives of q and v by v' within a step: `position` is beta' [s^2], `velocity` is gamma' [s]. They
/// are h^2 and h times constants of the method.
template <class S>
struct Shares {
  S position{0}, velocity{0};
};

///   Factors              empty at first; the next `factor` uses their storage again
///   factor               from (at, shares, factors): factors the matrix at an evaluation; with shares of 0
///                        only M and Phi_q. An evaluation can be factored once; afterwards it gives no
///                        residual, because the factors may take over its contents
///   solve                from (factors, at, left, rows, x, mu): solves with the matrix that was factored, at
///                        the state of the factors, and adds the solution to x and mu. `at` may be the
///                        evaluation of another state, such as a later iterate. x is in the velocity
///                        coordinates of the state of `at`
///   reduce               from (factors, force, left): eliminates the multipliers of internal rows from a
///                        generalised force, at the state of the factors. The result has the form of the
///                        upper part `left` of the right side of `solve`, and of the `left` of `residual`
///                        (residual.hpp)
///   inertia_force        from (factors, x, force): M x with M at the state of the factors
template <class System>
concept HasNewtonMatrix = HasResidual<System> && std::default_initializable<typename System::Factors> &&
    std::movable<typename System::Factors> &&
    requires(System& system, const typename System::Evaluation& at,
             const Shares<typename System::Scalar>& shares, typename System::Factors& made,
             const typename System::Factors& factors, const StateVector<typename System::Scalar>& v,
             StateVector<typename System::Scalar>& changed) {
  system.factor(at, shares, made);
  system.solve(factors, at, v, v, changed, changed);
  system.reduce(factors, v, changed);
  system.inertia_force(factors, v, changed);
};

}  // namespace trivium::integrators
