#pragma once
/// The scalar types in which the laws of rotations are tested. Used by tests only.

#include <gtest/gtest.h>

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"

namespace trivium::test {

using TestedScalars = testing::Types<float, double, Quad, Real50>;

}  // namespace trivium::test
