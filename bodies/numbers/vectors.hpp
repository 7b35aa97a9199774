#pragma once
/// Short names for Eigen's column vectors and matrices over any Scalar. Formulas in the code then look like
/// the printed ones.

#include <Eigen/Core>

#include "bodies/numbers/compiled_with.hpp"

namespace trivium {

template <class Scalar, int N>
using Vector = Eigen::Matrix<Scalar, N, 1>;
template <class Scalar, int R, int C>
using Matrix = Eigen::Matrix<Scalar, R, C>;
template <class Scalar>
using Vector3 = Vector<Scalar, 3>;
template <class Scalar>
using Vector4 = Vector<Scalar, 4>;
template <class Scalar>
using Matrix3 = Matrix<Scalar, 3, 3>;
template <class Scalar>
using VectorX = Vector<Scalar, Eigen::Dynamic>;
template <class Scalar>
using MatrixX = Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

}  // namespace trivium
