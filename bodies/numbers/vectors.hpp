#pragma once
/// Short names for Eigen's column vectors and matrices over any Scalar. Formulas in the code then look like
/// the printed ones.

#include <Eigen/Core>

#include "bodies/numbers/compiled_with.hpp"

namespace trivium {

/// A column of N numbers.
template <class Scalar, int N>
using Vector = Eigen::Matrix<Scalar, N, 1>;
/// A matrix [R x C].
template <class Scalar, int R, int C>
using Matrix = Eigen::Matrix<Scalar, R, C>;
/// A column of 3 numbers.
template <class Scalar>
using Vector3 = Vector<Scalar, 3>;
/// A column of 4 numbers, such as Euler parameters p.
template <class Scalar>
using Vector4 = Vector<Scalar, 4>;
/// A matrix [3x3].
template <class Scalar>
using Matrix3 = Matrix<Scalar, 3, 3>;
/// A column whose size is set at run time.
template <class Scalar>
using VectorX = Vector<Scalar, Eigen::Dynamic>;
/// A matrix whose size is set at run time.
template <class Scalar>
using MatrixX = Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

}  // namespace trivium
