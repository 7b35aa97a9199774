#pragma once
/// The Scalar of 113 bits, for motions that others are measured by. It is the type that
/// bodies/numbers/quad.hpp names too, which this room does not include.

#include <boost/multiprecision/float128.hpp>

namespace trivium::integrators {

using Quad =
    boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

}  // namespace trivium::integrators
