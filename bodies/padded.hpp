#pragma once
/// Vectors of three that fill a vector register: in double and float each gets a fourth place, always 0, so
/// that a column is added or scaled by one instruction. For innermost loops.

#include <cmath>
#include <cstring>
#include <type_traits>

#include "bodies/so3.hpp"

/// Calls of such small functions would pass their blocks through memory.
#define TRIVIUM_INLINE [[gnu::always_inline]] inline

namespace trivium {

template <class S>
inline constexpr int padded_size = std::is_floating_point_v<S> ? 4 : 3;
template <class S>
using Padded = Vector<S, padded_size<S>>;
/// n vectors of three.
template <class S, int n>
using PaddedColumns = Matrix<S, padded_size<S>, n>;

template <class S>
TRIVIUM_INLINE Padded<S> padded(const Vector3<S>& v) {
  if constexpr (padded_size<S> == 4)
    return {v.x(), v.y(), v.z(), S(0)};
  else
    return v;
}
template <class S>
TRIVIUM_INLINE Vector3<S> unpadded(const Padded<S>& v) {
  return v.template head<3>();
}

/// M N, of N the first n rows.
template <class S, int n, class Derived>
TRIVIUM_INLINE PaddedColumns<S, Derived::ColsAtCompileTime> times(const PaddedColumns<S, n>& M,
                                                                  const Eigen::MatrixBase<Derived>& N) {
  static_assert(Derived::RowsAtCompileTime >= n);
  PaddedColumns<S, Derived::ColsAtCompileTime> product;
  if constexpr (n == 0) {
    product.setZero();
  } else if constexpr (Derived::ColsAtCompileTime > 0) {
    for (int c = 0; c < product.cols(); ++c) {
      Padded<S> sum = M.col(0) * N(0, c);
      for (int k = 1; k < n; ++k) sum += M.col(k) * N(k, c);
      product.col(c) = sum;
    }
  }
  return product;
}

/// M N^T.
template <class S, int n>
TRIVIUM_INLINE PaddedColumns<S, 3> times_transpose(const PaddedColumns<S, n>& M,
                                                   const PaddedColumns<S, n>& N) {
  return times<S, n>(M, N.transpose().template leftCols<3>());
}

/// M^T v.
template <class S, int n>
TRIVIUM_INLINE Vector<S, n> transpose_times(const PaddedColumns<S, n>& M, const Padded<S>& v) {
  Vector<S, n> product;
  if constexpr (n > 0)
    for (int k = 0; k < n; ++k) product[k] = M.col(k).dot(v);
  return product;
}

template <class S>
TRIVIUM_INLINE Padded<S> cross_product(const Padded<S>& a, const Padded<S>& b) {
  if constexpr (std::is_same_v<S, double> || std::is_same_v<S, float>) {
    using Register [[gnu::vector_size(4 * sizeof(S))]] = S;
    using Places [[gnu::vector_size(4 * sizeof(S))]] = std::conditional_t<sizeof(S) == 8, long long, int>;
    constexpr Places next{1, 2, 0, 3};
    Register x, y;
    std::memcpy(&x, a.data(), sizeof x);
    std::memcpy(&y, b.data(), sizeof y);
    const Register z = x * __builtin_shuffle(y, next) - __builtin_shuffle(x, next) * y;
    const Register turned = __builtin_shuffle(z, next);
    Padded<S> product;
    std::memcpy(product.data(), &turned, sizeof turned);
    return product;
  } else {
    return padded<S>(unpadded<S>(a).cross(unpadded<S>(b)));
  }
}

/// M times the rotation by `angle` about coordinate axis k: two columns mix.
template <class S>
TRIVIUM_INLINE void turn(PaddedColumns<S, 3>& M, int k, const S& angle) {
  using std::cos, std::sin;
  const S c = cos(angle), s = sin(angle);
  const int m = (k + 1) % 3, n = (k + 2) % 3;
  const Padded<S> x = M.col(m), y = M.col(n);
  M.col(m) = c * x + s * y;
  M.col(n) = c * y - s * x;
}

template <class S>
TRIVIUM_INLINE PaddedColumns<S, 3> transposed(const PaddedColumns<S, 3>& M) {
  PaddedColumns<S, 3> T;
  for (int k = 0; k < 3; ++k) T.col(k) = padded<S>(M.template topRows<3>().row(k).transpose());
  return T;
}

/// Adds M + M^T to a symmetric block.
template <class S>
TRIVIUM_INLINE void add_with_transpose(const PaddedColumns<S, 3>& M, PaddedColumns<S, 3>& sum) {
  sum += M + transposed<S>(M);
}

}  // namespace trivium

#undef TRIVIUM_INLINE
