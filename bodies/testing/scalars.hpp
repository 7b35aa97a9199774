#pragma once
/// The Scalars in which laws of rotations are tried. A support of the tests.

#include <gtest/gtest.h>

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"

namespace trivium::test {

using TestedScalars = testing::Types<float, double, Quad, Real50>;

}  // namespace trivium::test
