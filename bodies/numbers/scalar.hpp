#pragma once
/// The scalar types of the library, in order of precision: float, double, long double, Quad (quad.hpp),
/// Real50 and Real100 (real50.hpp; Real100 only checks results in Real50). A Batch (batch.hpp) holds several
/// numbers of one type. All formulas are templates over the scalar type. This file defines the order of the
/// types, the unit roundoff and the cast of a matrix to another scalar. Only files that include quad.hpp or
/// real50.hpp depend on Boost.Multiprecision.

#include <Eigen/Core>
#include <limits>

namespace trivium {

/// The next more precise scalar type, used to measure the error of a result computed in Scalar.
template <class Scalar>
struct NextPrecision;
/// After float: double.
template <>
struct NextPrecision<float> {
  using type = double;
};
/// After double: long double.
template <>
struct NextPrecision<double> {
  using type = long double;
};
/// The type that NextPrecision gives.
template <class Scalar>
using NextPrecisionT = typename NextPrecision<Scalar>::type;

/// Unit roundoff u [-]: half the distance from 1 to the next greater number.
template <class Scalar>
Scalar unit_roundoff() {
  return std::numeric_limits<Scalar>::epsilon() / 2;
}

/// The vector or matrix `m` with its entries converted to the scalar type To.
template <class To, class Derived>
auto scalar_cast(const Eigen::MatrixBase<Derived>& m) {
  return m.unaryExpr([](const typename Derived::Scalar& x) { return static_cast<To>(x); }).eval();
}

}  // namespace trivium
