#pragma once
/// Forward-mode automatic differentiation of second order. Taylor is a scalar type that holds a value and its
/// first and second derivative with respect to one parameter. A function template of the library, called with
/// Taylor numbers, also returns these derivatives, without the error of difference quotients. Tests compare
/// them with the derivatives for which the library has formulas. Used by tests only.

#include <cmath>
#include <concepts>

#include "bodies/numbers/scalar.hpp"
#include "bodies/numbers/vectors.hpp"

namespace trivium::test {

template <class Base>
struct Taylor {
  Base d0{0}, d1{0}, d2{0};

  Taylor() = default;
  template <class Number>
  requires std::constructible_from<Base, Number> Taylor(const Number& value)  // NOLINT: a constant
      : d0(static_cast<Base>(value)) {}
  Taylor(const Base& value, const Base& first, const Base& second) : d0(value), d1(first), d2(second) {}
  /// The parameter itself: its first derivative is 1, its second 0.
  static Taylor parameter(const Base& value) { return {value, Base(1), Base(0)}; }

  Taylor operator-() const { return {-d0, -d1, -d2}; }
  friend Taylor operator+(const Taylor& a, const Taylor& b) {
    return {a.d0 + b.d0, a.d1 + b.d1, a.d2 + b.d2};
  }
  friend Taylor operator-(const Taylor& a, const Taylor& b) {
    return {a.d0 - b.d0, a.d1 - b.d1, a.d2 - b.d2};
  }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    return {a.d0 * b.d0, a.d1 * b.d0 + a.d0 * b.d1, a.d2 * b.d0 + 2 * a.d1 * b.d1 + a.d0 * b.d2};
  }
  friend Taylor operator/(const Taylor& a, const Taylor& b) {
    const Base q0 = a.d0 / b.d0, q1 = (a.d1 - q0 * b.d1) / b.d0;
    return {q0, q1, (a.d2 - 2 * q1 * b.d1 - q0 * b.d2) / b.d0};
  }
  Taylor& operator+=(const Taylor& b) { return *this = *this + b; }
  Taylor& operator-=(const Taylor& b) { return *this = *this - b; }
  Taylor& operator*=(const Taylor& b) { return *this = *this * b; }
  Taylor& operator/=(const Taylor& b) { return *this = *this / b; }

  friend bool operator==(const Taylor& a, const Taylor& b) { return a.d0 == b.d0; }
  friend bool operator<=(const Taylor& a, const Taylor& b) { return a.d0 <= b.d0; }
  friend bool operator>=(const Taylor& a, const Taylor& b) { return a.d0 >= b.d0; }
  friend bool operator<(const Taylor& a, const Taylor& b) { return a.d0 < b.d0; }
  friend bool operator>(const Taylor& a, const Taylor& b) { return a.d0 > b.d0; }

  /// g(a) by the chain rule, from g, g' and g'' at a.d0.
  static Taylor chain(const Taylor& a, const Base& g, const Base& g_1, const Base& g_2) {
    return {g, g_1 * a.d1, g_1 * a.d2 + g_2 * a.d1 * a.d1};
  }
  friend Taylor abs(const Taylor& a) { return a.d0 < Base(0) ? -a : a; }
  friend Taylor sin(const Taylor& a) {
    using std::cos, std::sin;
    const Base s = sin(a.d0), c = cos(a.d0);
    return chain(a, s, c, -s);
  }
  friend Taylor cos(const Taylor& a) {
    using std::cos, std::sin;
    const Base s = sin(a.d0), c = cos(a.d0);
    return chain(a, c, -s, -c);
  }
  friend Taylor sqrt(const Taylor& a) {
    using std::sqrt;
    const Base root = sqrt(a.d0), g_1 = 1 / (2 * root);
    return chain(a, root, g_1, -g_1 / (2 * a.d0));
  }
};

/// A vector or matrix over Taylor from its value and its first and second derivative.
template <class Base, int R, int C>
Matrix<Taylor<Base>, R, C> taylor(const Matrix<Base, R, C>& value, const Matrix<Base, R, C>& first,
                                  const Matrix<Base, R, C>& second) {
  Matrix<Taylor<Base>, R, C> out;
  for (Eigen::Index r = 0; r < R; ++r)
    for (Eigen::Index c = 0; c < C; ++c) out(r, c) = {value(r, c), first(r, c), second(r, c)};
  return out;
}
template <class Base, int R, int C>
Matrix<Taylor<Base>, R, C> constant(const Matrix<Base, R, C>& value) {
  const Matrix<Base, R, C> zero = Matrix<Base, R, C>::Zero();
  return taylor<Base, R, C>(value, zero, zero);
}

/// The first or second derivative of every entry.
template <class Base, int R, int C>
Matrix<Base, R, C> first_derivative(const Matrix<Taylor<Base>, R, C>& m) {
  return m.unaryExpr([](const Taylor<Base>& x) { return x.d1; }).eval();
}
template <class Base, int R, int C>
Matrix<Base, R, C> second_derivative(const Matrix<Taylor<Base>, R, C>& m) {
  return m.unaryExpr([](const Taylor<Base>& x) { return x.d2; }).eval();
}

}  // namespace trivium::test

namespace Eigen {
template <class Base>
struct NumTraits<trivium::test::Taylor<Base>> : GenericNumTraits<Base> {
  using Real = trivium::test::Taylor<Base>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 3,
    AddCost = 3,
    MulCost = 9
  };
};
}  // namespace Eigen
