#pragma once
/// 3-vectors padded to a vector register, for innermost loops. In float, double and long double a padded
/// vector has a fourth entry, always 0. One instruction then adds or scales a vector, in float always and in
/// double if the processor has AVX. Products of 3 x n matrices work on padded columns.

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "bodies/numbers/vectors.hpp"

/// Forces inlining: a function call would pass the vectors through memory instead of registers.
#define TRIVIUM_INLINE [[gnu::always_inline]] inline

namespace trivium {

/// Number of entries of a padded vector over S.
template <class S>
inline constexpr int padded_size = std::is_floating_point_v<S> ? 4 : 3;
/// A padded 3-vector.
template <class S>
using Padded = Vector<S, padded_size<S>>;
/// A 3 x n matrix whose columns are padded vectors.
template <class S, int n>
using PaddedColumns = Matrix<S, padded_size<S>, n>;

/// Size of the registers that Register may use.
#ifdef __AVX__
inline constexpr std::size_t register_bytes = 32;
#else
inline constexpr std::size_t register_bytes = 16;
#endif

/// The four entries of a padded vector as one register. `exists` is true if S is float or double and a
/// register holds four numbers of type S. Vectors are assembled in the register: four separate stores to
/// memory, followed by one load of all four entries, would stall the processor for about a dozen cycles.
template <class S>
struct Register {
  static constexpr bool exists =
      (std::is_same_v<S, double> || std::is_same_v<S, float>)&&4 * sizeof(S) <= register_bytes;
  using Number = std::conditional_t<exists, S, double>;

  Number places [[gnu::vector_size(4 * sizeof(Number))]];

  TRIVIUM_INLINE static Register of(const Padded<S>& v) {
    Register loaded;
    std::memcpy(&loaded.places, v.data(), sizeof loaded.places);
    return loaded;
  }
  TRIVIUM_INLINE Padded<S> padded() const {
    Padded<S> stored;
    std::memcpy(stored.data(), &places, sizeof places);
    return stored;
  }

  // entries of a and b side by side. even: (a0, b0, a2, b2), odd: (a1, b1, a3, b3), front: (a0, a1, b0, b1),
  // back: (a2, a3, b2, b3)
  TRIVIUM_INLINE static Register even(const Register& a, const Register& b) {
    return {__builtin_shufflevector(a.places, b.places, 0, 4, 2, 6)};
  }
  TRIVIUM_INLINE static Register odd(const Register& a, const Register& b) {
    return {__builtin_shufflevector(a.places, b.places, 1, 5, 3, 7)};
  }
  TRIVIUM_INLINE static Register front(const Register& a, const Register& b) {
    return {__builtin_shufflevector(a.places, b.places, 0, 1, 4, 5)};
  }
  TRIVIUM_INLINE static Register back(const Register& a, const Register& b) {
    return {__builtin_shufflevector(a.places, b.places, 2, 3, 6, 7)};
  }
  /// (y, z, x), a cyclic shift of (x, y, z).
  TRIVIUM_INLINE Register turned() const { return {__builtin_shufflevector(places, places, 1, 2, 0, 3)}; }

  TRIVIUM_INLINE friend Register operator+(const Register& a, const Register& b) {
    return {a.places + b.places};
  }
  TRIVIUM_INLINE friend Register operator-(const Register& a, const Register& b) {
    return {a.places - b.places};
  }
  TRIVIUM_INLINE friend Register operator*(const Register& a, const Register& b) {
    return {a.places * b.places};
  }
};

/// The padded vector of v.
template <class S>
TRIVIUM_INLINE Padded<S> padded(const Vector3<S>& v) {
  if constexpr (Register<S>::exists)
    return Register<S>{{v.x(), v.y(), v.z(), S(0)}}.padded();
  else if constexpr (padded_size<S> == 4)
    return {v.x(), v.y(), v.z(), S(0)};
  else
    return v;
}
/// The first three entries of v.
template <class S>
TRIVIUM_INLINE Vector3<S> unpadded(const Padded<S>& v) {
  return v.template head<3>();
}

/// M [3x3] with padded columns.
template <class S>
TRIVIUM_INLINE PaddedColumns<S, 3> padded_columns(const Matrix3<S>& M) {
  PaddedColumns<S, 3> columns;
  for (int k = 0; k < 3; ++k) columns.col(k) = padded<S>(M.col(k));
  return columns;
}

/// M N [3 x columns], with M [3 x n]; uses only the first n rows of N.
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

/// M N^T [3x3], with M and N [3 x n].
template <class S, int n>
TRIVIUM_INLINE PaddedColumns<S, 3> times_transpose(const PaddedColumns<S, n>& M,
                                                   const PaddedColumns<S, n>& N) {
  return times<S, n>(M, N.transpose().template leftCols<3>());
}

/// M^T v [n], with M [3 x n].
template <class S, int n>
TRIVIUM_INLINE Vector<S, n> transpose_times(const PaddedColumns<S, n>& M, const Padded<S>& v) {
  using R = Register<S>;
  Vector<S, n> product;
  if constexpr (n == 2 && R::exists) {
    const R w = R::of(v), a = R::of(M.col(0)) * w, b = R::of(M.col(1)) * w;
    const Padded<S> ab = (R::even(a, b) + R::odd(a, b)).padded();
    product = ab.template head<2>() + ab.template tail<2>();
  } else if constexpr (n > 0) {
    for (int k = 0; k < n; ++k) product[k] = M.col(k).dot(v);
  }
  return product;
}
/// M^T v as a padded vector, with M [3x3].
template <class S>
TRIVIUM_INLINE Padded<S> padded_transpose_times(const PaddedColumns<S, 3>& M, const Padded<S>& v) {
  using R = Register<S>;
  if constexpr (R::exists) {
    const R w = R::of(v), a = R::of(M.col(0)) * w, b = R::of(M.col(1)) * w, c = R::of(M.col(2)) * w, none{};
    const R ab = R::even(a, b) + R::odd(a, b), c0 = R::even(c, none) + R::odd(c, none);
    return (R::front(ab, c0) + R::back(ab, c0)).padded();
  } else {
    return padded<S>(transpose_times<S, 3>(M, v));
  }
}

/// a x b.
template <class S>
TRIVIUM_INLINE Padded<S> cross_product(const Padded<S>& a, const Padded<S>& b) {
  using R = Register<S>;
  if constexpr (R::exists) {
    const R x = R::of(a), y = R::of(b);
    return (x * y.turned() - x.turned() * y).turned().padded();
  } else {
    return padded<S>(unpadded<S>(a).cross(unpadded<S>(b)));
  }
}

/// M := M R_k(angle), with R_k the rotation about coordinate axis k, angle in rad. Changes two columns of M.
template <class S>
TRIVIUM_INLINE void turn(PaddedColumns<S, 3>& M, int k, const S& angle) {
  using std::cos, std::sin;
  const S c = cos(angle), s = sin(angle);
  const int m = (k + 1) % 3, n = (k + 2) % 3;
  const Padded<S> x = M.col(m), y = M.col(n);
  M.col(m) = c * x + s * y;
  M.col(n) = c * y - s * x;
}

/// M^T [3x3].
template <class S>
TRIVIUM_INLINE PaddedColumns<S, 3> transposed(const PaddedColumns<S, 3>& M) {
  using R = Register<S>;
  PaddedColumns<S, 3> T;
  if constexpr (R::exists) {
    const R a = R::of(M.col(0)), b = R::of(M.col(1)), c = R::of(M.col(2)), none{};
    const R ab = R::even(a, b), c0 = R::even(c, none);
    T.col(0) = R::front(ab, c0).padded();
    T.col(1) = R::front(R::odd(a, b), R::odd(c, none)).padded();
    T.col(2) = R::back(ab, c0).padded();
  } else {
    for (int k = 0; k < 3; ++k) T.col(k) = padded<S>(M.template topRows<3>().row(k).transpose());
  }
  return T;
}

/// sum += M + M^T.
template <class S>
TRIVIUM_INLINE void add_with_transpose(const PaddedColumns<S, 3>& M, PaddedColumns<S, 3>& sum) {
  sum += M + transposed<S>(M);
}

}  // namespace trivium

#undef TRIVIUM_INLINE
