#pragma once
/// Real50, the scalar type with 50 decimal digits: the most precise one in which the library computes.
/// Results in Quad are compared with results in Real50, and these with results in Real100.

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "bodies/numbers/quad.hpp"

namespace trivium {

/// 50 decimal digits.
using Real50 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
/// 100 decimal digits, to check results in Real50.
using Real100 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// After Quad: Real50.
template <>
struct NextPrecision<Quad> {
  using type = Real50;
};
/// After Real50: Real100.
template <>
struct NextPrecision<Real50> {
  using type = Real100;
};

}  // namespace trivium

namespace Eigen {
/// Eigen's traits of Real50.
template <>
struct NumTraits<trivium::Real50> : trivium::detail::MultiprecisionTraits<trivium::Real50> {};
/// Eigen's traits of Real100.
template <>
struct NumTraits<trivium::Real100> : trivium::detail::MultiprecisionTraits<trivium::Real100> {};
}  // namespace Eigen
