#pragma once
/// The ladder of scalars that every formula of the library is written over: float, double, long double, quad,
/// 50 digits.

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/float128.hpp>
#include <limits>
#include <type_traits>

namespace trivium {

/// IEEE binary128: 113 bits.
using Quad =
    boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;
/// 50 decimal digits.
using Real50 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
/// 100 decimal digits: judges Real50.
using Real100 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

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
template <>
struct NextPrecision<long double> {
  using type = Quad;
};
template <>
struct NextPrecision<Quad> {
  using type = Real50;
};
template <>
struct NextPrecision<Real50> {
  using type = Real100;
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

namespace detail {
/// Eigen's view of a Boost number. Boost 1.74 ships one whose lowest() is positive and that has no infinity.
template <class Number>
struct MultiprecisionTraits : Eigen::GenericNumTraits<Number> {
  using Limits = std::numeric_limits<Number>;
  using Real = Number;
  using NonInteger = Number;
  using Nested = Number;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 4,
    AddCost = 32,
    MulCost = 64
  };
  static Number epsilon() { return Limits::epsilon(); }
  static Number dummy_precision() { return 1000 * Limits::epsilon(); }
  static Number highest() { return (Limits::max)(); }
  static Number lowest() { return -(Limits::max)(); }
  static Number infinity() { return Limits::infinity(); }
  static Number quiet_NaN() { return Limits::quiet_NaN(); }
  static int digits10() { return Limits::digits10; }
};
}  // namespace detail

}  // namespace trivium

namespace Eigen {
template <>
struct NumTraits<trivium::Quad> : trivium::detail::MultiprecisionTraits<trivium::Quad> {};
template <>
struct NumTraits<trivium::Real50> : trivium::detail::MultiprecisionTraits<trivium::Real50> {};
template <>
struct NumTraits<trivium::Real100> : trivium::detail::MultiprecisionTraits<trivium::Real100> {};
}  // namespace Eigen
