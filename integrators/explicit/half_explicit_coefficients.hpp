#pragma once
/// The coefficients of the half-explicit methods HEM4 (Brasey and Hairer, SIAM Journal on Numerical Analysis
/// 30, 1993) and HEDOP5 (Arnold and Murua, Numerical Algorithms 19, 1998). Tests check their order
/// conditions.

#include <array>
#include <cmath>

namespace trivium::integrators {

/// The coefficients of HEM4; the last row is that of the step.
template <class S>
struct Hem4Coefficients {
  static constexpr int stages = 5, end = 5;  ///< `end` is the row of the step
  static constexpr bool first_is_known = false;
  std::array<S, 6> c;
  std::array<std::array<S, 5>, 6> a;

  Hem4Coefficients() {
    using std::sqrt;
    const S r = sqrt(S(6)), o(0);
    c = {o, S(3) / 10, (4 - r) / 10, (4 + r) / 10, S(1), S(1)};
    a = {{{o, o, o, o, o},
          {S(3) / 10, o, o, o, o},
          {(1 + r) / 30, (11 - 4 * r) / 30, o, o, o},
          {(-79 - 31 * r) / 150, (-1 - 4 * r) / 30, (24 + 11 * r) / 25, o, o},
          {(14 + 5 * r) / 6, (-8 + 7 * r) / 6, (-9 - 7 * r) / 4, (9 - r) / 4, o},
          {o, o, (16 - r) / 36, (16 + r) / 36, S(1) / 9}}};
  }
};

/// The coefficients of HEDOP5. The last row, at 19/20, gives the state whose rows the seventh stage meets.
template <class S>
struct Hedop5Coefficients {
  static constexpr int stages = 7, end = 6;
  static constexpr bool first_is_known = true;
  std::array<S, 8> c;
  std::array<std::array<S, 7>, 8> a;
  std::array<S, 7> embedded;  ///< weights of the embedded formula of order 4

  Hedop5Coefficients() {
    const S o(0);
    const auto of = [](long long n, long long d) { return S(S(n) / S(d)); };
    c = {o, of(1, 5), of(3, 10), of(4, 5), of(8, 9), S(1), S(1), of(19, 20)};
    a = {{{o, o, o, o, o, o, o},
          {of(1, 5), o, o, o, o, o, o},
          {of(3, 40), of(9, 40), o, o, o, o, o},
          {of(44, 45), of(-56, 15), of(32, 9), o, o, o, o},
          {of(19372, 6561), of(-25360, 2187), of(64448, 6561), of(-212, 729), o, o, o},
          {of(9017, 3168), of(-355, 33), of(46732, 5247), of(49, 176), of(-5103, 18656), o, o},
          {of(35, 384), o, of(500, 1113), of(125, 192), of(-2187, 6784), of(11, 84), o},
          {of(-18611506045861, 19738176307200), of(59332529, 14479296), of(-2509441598627, 893904224850),
           of(2763523204159, 3289696051200), of(-41262869588913, 116235927142400),
           of(46310205821, 287848404480), of(-3280, 75413)}}};
    embedded = {of(5179, 57600), o,        of(7571, 16695), of(393, 640), of(-92097, 339200),
                of(187, 2100),   of(1, 40)};
  }
};

}  // namespace trivium::integrators
