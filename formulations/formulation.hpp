#pragma once
/// The contract of a formulation: one set of absolute coordinates (r, orientation) per body and the equations
/// of motion written in it. Four files stand side by side, same headings, same order: r_omega, r_p, r_epsilon
/// and r_epsilon_omega_first. Each is native: its Jacobians, biases, mass block and forces come from its own
/// coordinates, never from another formulation's numbers; that lambda agrees is the theorem, not the
/// implementation.
///
/// The contract has three parts: the equations as printed, the same with the internal row eliminated, and the
/// coordinates moved in time. Their laws are in contract/laws.hpp.

#include "formulations/contract/equations_as_printed.hpp"
#include "formulations/contract/moving_coordinates.hpp"
#include "formulations/contract/reduced_equations.hpp"
#include "mechanism/model.hpp"

namespace trivium {

template <class F>
concept Formulation = EquationsAsPrinted<F> && ReducedEquations<F> && MovingCoordinates<F>;

namespace detail {
template <class F, class Scalar>
struct InScalar;
template <template <class> class F, class S, class Scalar>
struct InScalar<F<S>, Scalar> {
  using type = F<Scalar>;
};
template <class F>
struct TypesOf {
  using type = StandardTypes;
};
template <class F>
requires requires { typename F::Types; }
struct TypesOf<F> {
  using type = typename F::Types;
};
}  // namespace detail

/// What the solvers and simulations of a formulation take.
template <class F>
using MechanismTypesOf = typename detail::TypesOf<F>::type;
template <class F>
using MechanismOf = Mechanism<typename F::Scalar, MechanismTypesOf<F>>;
template <class F>
using ModelOf = Model<typename F::Scalar, MechanismTypesOf<F>>;

/// The same formulation for mechanisms with other types of constraints and effects: nothing of it changes but
/// the mechanisms that its solvers take.
template <template <class> class F, class OfTypes>
struct Retyped {
  template <class S>
  struct In : F<S> {
    using Types = OfTypes;
  };
};

/// The same formulation over another Scalar.
template <class F, class Scalar>
using InScalarT = typename detail::InScalar<F, Scalar>::type;

}  // namespace trivium
