#pragma once
/// The coefficients of Radau IIA: Hairer and Wanner, Solving Ordinary Differential Equations II (1996), IV.5
/// and IV.8. They are computed for any odd number of stages, from the zeros of the polynomial that defines c.
/// For S = double the computation is in quad.

#include <Eigen/LU>
#include <array>
#include <limits>
#include <type_traits>

#include "integrators/quad.hpp"

namespace trivium::integrators {

/// The coefficients for s stages, s odd; the method has order 2 s - 1.
template <class S, int s>
struct RadauCoefficients {
  static_assert(s % 2 == 1, "an even number of stages has no real eigenvalue");

  std::array<S, s> c;      ///< nodes [-]; the last is 1
  std::array<S, s> error;  ///< estimated error, of order s: h gamma f(y_n) + sum error_i (Y_i - y_n)
  std::array<std::array<S, s>, s> a, inverse, square;  ///< A, A^-1, A^2
  S gamma;                                             ///< the real eigenvalue of A

  RadauCoefficients() {
    const auto nodes = nodes_of_quadrature();
    const Wide eigenvalue = real_eigenvalue();
    // collocation: A maps the values c^(k-1) to c^k / k for k = 1 .. s
    Square powers, integrals;
    for (int i = 0; i < s; ++i) {
      Wide power(1);
      for (int k = 0; k < s; ++k) {
        powers(i, k) = power;
        power *= nodes[i];
        integrals(i, k) = power / (k + 1);
      }
    }
    const Square from_powers = powers.inverse(), A = integrals * from_powers, A_inverse = A.inverse();
    const Square A_square = A * A;
    const Eigen::Matrix<Wide, 1, s> e = -eigenvalue * from_powers.row(0) * A_inverse;
    for (int i = 0; i < s; ++i) {
      c[i] = static_cast<S>(nodes[i]);
      error[i] = static_cast<S>(e[i]);
      for (int j = 0; j < s; ++j) {
        a[i][j] = static_cast<S>(A(i, j));
        inverse[i][j] = static_cast<S>(A_inverse(i, j));
        square[i][j] = static_cast<S>(A_square(i, j));
      }
    }
    gamma = static_cast<S>(eigenvalue);
  }

 private:
  /// The scalar of the computation. The inverse of the matrix of powers of c loses some digits, hence quad
  /// for doubles.
  using Wide = std::conditional_t<std::is_same_v<S, double>, Quad, S>;
  using Square = Eigen::Matrix<Wide, s, s>;

  struct Value {
    Wide f, slope;
  };
  /// The zero of f by Newton's method, from a start where the iteration is monotone. It ends when rounding
  /// stops the steps from becoming smaller.
  template <class F>
  static Wide root(Wide x, const F& f) {
    for (Wide before = std::numeric_limits<Wide>::max();;) {
      const Value at = f(x);
      const Wide step = at.f / at.slope;
      using std::abs;
      if (!(abs(step) < before)) return x;
      before = abs(step);
      x -= step;
    }
  }
  /// The zeros of P_s - P_(s-1), Legendre polynomials on [0, 1], from left to right. Zeros that are known are
  /// divided out (deflation).
  static std::array<Wide, s> nodes_of_quadrature() {
    std::array<Wide, s> nodes;
    nodes.back() = 1;
    for (int found = 0; found < s - 1; ++found)
      nodes[found] = root(Wide(0), [&](const Wide& x) {
        const Wide z = 2 * x - 1;
        Value before{Wide(1), Wide(0)}, now{z, Wide(2)};
        for (int k = 1; k < s; ++k) {
          const Value next{((2 * k + 1) * z * now.f - k * before.f) / (k + 1),
                           ((2 * k + 1) * (2 * now.f + z * now.slope) - k * before.slope) / (k + 1)};
          before = now;
          now = next;
        }
        Value left{now.f - before.f, now.slope - before.slope};
        for (int k = 0; k < found; ++k) left.slope -= left.f / (x - nodes[k]);
        left.slope -= left.f / (x - 1);
        return left;
      });
    return nodes;
  }
  /// 1 / z, where z is the real zero of the stability function's denominator, a Pade denominator of exp
  /// (IV.3). Newton's method starts at 10 s, to the right of all zeros. z is the zero farthest to the right,
  /// so that the iteration is monotone.
  static Wide real_eigenvalue() {
    return 1 / root(Wide(10 * s), [](const Wide& z) {
             Wide term(1);
             Value q{Wide(1), Wide(0)};
             for (int j = 1; j <= s; ++j) {
               const Wide factor = Wide(s - j + 1) / (j * (2 * s - j));
               q.slope = q.slope - j * factor * term;
               term *= -factor * z;
               q.f += term;
             }
             return q;
           });
  }
};

}  // namespace trivium::integrators
