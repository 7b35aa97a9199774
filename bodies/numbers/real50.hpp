#pragma once
/// Real50, the scalar of 50 decimal digits: the top of the ladder, which judges results computed in Quad.
/// Real100 judges Real50.

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "bodies/numbers/quad.hpp"

namespace trivium {

/// 50 decimal digits.
using Real50 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
/// 100 decimal digits: judges Real50.
using Real100 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

template <>
struct NextPrecision<Quad> {
  using type = Real50;
};
template <>
struct NextPrecision<Real50> {
  using type = Real100;
};

}  // namespace trivium

namespace Eigen {
template <>
struct NumTraits<trivium::Real50> : trivium::detail::MultiprecisionTraits<trivium::Real50> {};
template <>
struct NumTraits<trivium::Real100> : trivium::detail::MultiprecisionTraits<trivium::Real100> {};
}  // namespace Eigen
