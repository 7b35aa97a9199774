#pragma once
/// The contract of a formulation: one set of absolute coordinates (r, orientation) per body, and the
/// equations of motion written in these coordinates. Four parallel files have the same headings in the same
/// order: r_omega, r_p, r_epsilon and r_epsilon_omega_first. The first three compute Jacobians, biases,
/// mass blocks and forces from their own coordinates alone, never from the numbers of another formulation.
/// So the equality of their lambda is a result and does not come from shared code. The fourth combines the
/// angles of r_epsilon with the equations of r_omega.
///
/// The contract has three parts: the equations as printed, the equations with the internal row eliminated,
/// and the motion of the coordinates in time. What each function must satisfy is tested by
/// contract/laws.hpp.

#include "formulations/contract/equations_as_printed.hpp"
#include "formulations/contract/moving_coordinates.hpp"
#include "formulations/contract/reduced_equations.hpp"
#include "mechanism/model.hpp"

namespace trivium {

/// A formulation with all three parts, which every solver and simulation accepts.
template <class F>
concept Formulation = EquationsAsPrinted<F> && ReducedEquations<F> && MovingCoordinates<F>;

namespace detail {
/// Defines InScalarT.
template <class F, class Scalar>
struct InScalar;
/// InScalarT of a template over its Scalar alone.
template <template <class> class F, class S, class Scalar>
struct InScalar<F<S>, Scalar> {
  using type = F<Scalar>;
};
/// MechanismTypesOf an F without Types.
template <class F>
struct TypesOf {
  using type = StandardTypes;
};
/// MechanismTypesOf an F with Types.
template <class F>
requires requires { typename F::Types; }
struct TypesOf<F> {
  using type = typename F::Types;
};
}  // namespace detail

/// Types of constraints and effects in the mechanisms that the solvers of F accept; F::Types, or else the
/// library's.
template <class F>
using MechanismTypesOf = typename detail::TypesOf<F>::type;
/// The mechanisms that the solvers of F accept.
template <class F>
using MechanismOf = Mechanism<typename F::Scalar, MechanismTypesOf<F>>;
/// The models that the solvers of F accept.
template <class F>
using ModelOf = Model<typename F::Scalar, MechanismTypesOf<F>>;

/// The formulation F for mechanisms with other types of constraints and effects. Only the mechanism type
/// that its solvers accept changes.
template <template <class> class F, class OfTypes>
struct Retyped {
  /// The formulation in the scalar S.
  template <class S>
  struct In : F<S> {
    using Types = OfTypes;
  };
};

/// The formulation F over another Scalar.
template <class F, class Scalar>
using InScalarT = typename detail::InScalar<F, Scalar>::type;

}  // namespace trivium
