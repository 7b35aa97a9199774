#pragma once
/// Quad: the scalar type with 113 bits of mantissa, for reference motions. It is the same type as in
/// bodies/numbers/quad.hpp, which this directory does not include.

#include <boost/multiprecision/float128.hpp>

namespace trivium::integrators {

/// IEEE binary128.
using Quad =
    boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

}  // namespace trivium::integrators
