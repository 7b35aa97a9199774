#pragma once
/// Newton's matrix of a step: M, the stiffness K and damping C of springs by the step's shares, and Phi_q,
///
///   [ M + gamma' C + beta' K   Phi_q^T ] [ x  ]   [ left ]
///   [ Phi_q                    0       ] [ mu ] = [ rows ]
///
/// in factors, which are a value too. They are kept for as long as a method likes, beside others.

#include <concepts>

#include "integrators/contract/residual.hpp"

namespace trivium::integrators {

/// How far q and v of a step move with v': beta' and gamma' (h^2 and h, times numbers of the method).
template <class S>
struct Shares {
  S position{0}, velocity{0};
};

///   Factors              empty at first; their storage is used again by the next `factor`
///   factor               from (at, shares, factors): factors of the matrix at an evaluation; of M and Phi_q
///                        alone for shares of 0. The evaluation is factored once, and asked for no
///                        residual afterwards: factors may take what it holds
///   solve                from (factors, at, left, rows, x, mu): adds the solution to x, which is of v's kind
///                        where `at` is, and to mu
///   reduce               from (factors, force, left): a force of v's kind as `solve` takes it, reduced where
///                        the factors are
///   inertia_force        from (factors, x, force): M x where the factors are
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
