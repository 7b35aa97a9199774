#pragma once
/// Quad, the scalar type of IEEE binary128: unit roundoff u = 2^-113, about 34 decimal digits. Results in
/// long double are compared with results in Quad.

#include <Eigen/Core>
#include <boost/multiprecision/float128.hpp>
#include <limits>

#include "bodies/numbers/scalar.hpp"

namespace trivium {

/// IEEE binary128: 113 bits.
using Quad =
    boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

/// After long double: Quad.
template <>
struct NextPrecision<long double> {
  using type = Quad;
};

namespace detail {
/// Eigen's traits of a Boost.Multiprecision number. The traits of Boost 1.74 are not used: their lowest() is
/// positive and they have no infinity. The costs are rough: they make Eigen store an intermediate result
/// that is used several times instead of computing it again. dummy_precision(), the tolerance of isApprox(),
/// is that of Boost.
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
/// Eigen's traits of Quad.
template <>
struct NumTraits<trivium::Quad> : trivium::detail::MultiprecisionTraits<trivium::Quad> {};
}  // namespace Eigen
