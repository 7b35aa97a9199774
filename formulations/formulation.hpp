#pragma once
/// The contract of a formulation: one set of absolute coordinates (r, orientation) per body and the equations
/// of motion written in it. Four files stand side by side, same headings, same order: r_omega, r_p, r_epsilon
/// and r_epsilon_omega_first. Each is native: its Jacobians, biases, mass block and forces come from its own
/// coordinates, never from another formulation's numbers; that lambda agrees is the theorem, not the
/// implementation.
///
/// The contract has three parts: the equations as printed, the same with the internal row eliminated, and the
/// coordinates moved in time. Their laws are the files NAME_laws_test.cpp.

#include "formulations/contract/equations_as_printed.hpp"
#include "formulations/contract/moving_coordinates.hpp"
#include "formulations/contract/reduced_equations.hpp"

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
}  // namespace detail

/// The same formulation over another Scalar.
template <class F, class Scalar>
using InScalarT = typename detail::InScalar<F, Scalar>::type;

}  // namespace trivium
