#pragma once
/// The polynomial through values at given points (Lagrange). Its value at a point, its slope at the first
/// point and its integral are sums of weights times the values. The points may have any distances, so that
/// formulas of multistep methods follow for steps of unequal length.

#include <array>
#include <cmath>
#include <utility>

namespace trivium::integrators {

/// Points of a polynomial, or weights of its values. `n` is the number of points, at most 6.
template <class S>
struct PolynomialNumbers {
  int n = 0;
  std::array<S, 6> of;

  void add(const S& number) { of[n++] = number; }
  const S& operator[](int k) const { return of[k]; }
};

/// Weights of the value at x.
template <class S>
PolynomialNumbers<S> value_weights(const PolynomialNumbers<S>& at, const S& x) {
  PolynomialNumbers<S> weights;
  for (int j = 0; j < at.n; ++j) {
    S weight(1);
    for (int i = 0; i < at.n; ++i)
      if (i != j) weight *= (x - at[i]) / (at[j] - at[i]);
    weights.add(weight);
  }
  return weights;
}

/// Weights of the slope at the first point.
template <class S>
PolynomialNumbers<S> slope_weights(const PolynomialNumbers<S>& at) {
  PolynomialNumbers<S> weights;
  S own(0);
  for (int i = 1; i < at.n; ++i) own += 1 / (at[0] - at[i]);
  weights.add(own);
  for (int j = 1; j < at.n; ++j) {
    S weight = 1 / (at[j] - at[0]);
    for (int i = 1; i < at.n; ++i)
      if (i != j) weight *= (at[0] - at[i]) / (at[j] - at[i]);
    weights.add(weight);
  }
  return weights;
}

/// Weights of the integral from a to b, by the formula of Gauss with 3 points, which is exact here.
template <class S>
PolynomialNumbers<S> integral_weights(const PolynomialNumbers<S>& at, const S& a, const S& b) {
  using std::sqrt;
  const S middle = (a + b) / 2, half = (b - a) / 2, far = half * sqrt(S(3) / 5);
  PolynomialNumbers<S> weights;
  for (int j = 0; j < at.n; ++j) weights.add(S(0));
  for (const auto& [x, share] :
       {std::pair<S, S>(middle - far, S(5) / 9), {middle, S(8) / 9}, {middle + far, S(5) / 9}}) {
    const PolynomialNumbers<S> values = value_weights(at, x);
    for (int j = 0; j < at.n; ++j) weights.of[j] += half * share * values[j];
  }
  return weights;
}

}  // namespace trivium::integrators
