#pragma once
/// The scalars that every formula of the library is written over: float, double, long double, Quad
/// (quad.hpp), Real50 (real50.hpp). Here stand their order, the unit roundoff and the cast of a matrix from
/// one scalar to another. A file that names Quad or Real50 includes their header, so that
/// no other file depends on Boost.Multiprecision.

#include <Eigen/Core>
#include <limits>

namespace trivium {

/// The next rung of the ladder: precise enough to judge a result computed in Scalar.
template <class Scalar>
struct NextPrecision;
template <>
struct NextPrecision<float> {
  using type = double;
};
template <>
struct NextPrecision<double> {
  using type = long double;
};
template <class Scalar>
using NextPrecisionT = typename NextPrecision<Scalar>::type;

/// u: half the distance from 1 to the next number.
template <class Scalar>
Scalar unit_roundoff() {
  return std::numeric_limits<Scalar>::epsilon() / 2;
}

/// Matrix entries from one Scalar to another.
template <class To, class Derived>
auto scalar_cast(const Eigen::MatrixBase<Derived>& m) {
  return m.unaryExpr([](const typename Derived::Scalar& x) { return static_cast<To>(x); }).eval();
}

}  // namespace trivium
