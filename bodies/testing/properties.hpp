#pragma once
/// Property tests with random arguments: the test driver, generators of arguments, and measures of distance
/// in units of rounding errors. Used by tests only.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <cmath>
#include <sstream>

#include "bodies/numbers/scalar.hpp"
#include "bodies/numbers/vectors.hpp"
#include "bodies/rotations/euler_sequence.hpp"

namespace trivium::test {

/// Tests `law` in `cases` random cases; the law draws its arguments by `*rc::gen...`. The seed is fixed, so
/// every run tests the same cases. RapidCheck reduces a failing case to a simpler one before it reports it.
template <class Law>
void for_all(const Law& law, int cases = 200) {
  const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
  rc::detail::TestMetadata metadata;
  metadata.id = metadata.description = info->name();
  rc::detail::TestParams params;
  params.seed = 313;
  params.maxSuccess = cases;
  rc::detail::TestListenerAdapter quiet;
  const auto result = rc::detail::checkProperty(rc::detail::toProperty(law), metadata, params, quiet, {});
  if (result.template is<rc::detail::SuccessResult>()) return;
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  ADD_FAILURE() << text.str();
}

/// A random multiple of 2^-10 in [-size, size]: exact in every Scalar.
template <class S>
S draw_number(int size = 1) {
  return S(*rc::gen::inRange(-1024 * size, 1024 * size + 1)) / 1024;
}
template <class S, int N>
Vector<S, N> draw_vector(int size = 1) {
  Vector<S, N> v;
  for (int k = 0; k < N; ++k) v[k] = draw_number<S>(size);
  return v;
}
template <class S>
Vector4<S> draw_euler_parameters() {
  Vector4<S> p = draw_vector<S, 4>();
  if (p.norm() < S(0.1)) p = Vector4<S>::Unit(0);
  return p / p.norm();
}
inline EulerSequence draw_sequence() {
  return *parse_euler_sequence(euler_sequence_names[*rc::gen::inRange<std::size_t>(0, 12)]);
}

/// max |a[k] - b[k]|; NaN if an entry is NaN.
template <class S>
double distance(const S* a, const S* b, Eigen::Index n) {
  using std::abs, std::isnan;
  S largest(0);
  for (Eigen::Index k = 0; k < n; ++k) {
    const S d = abs(a[k] - b[k]);
    if (isnan(d)) return std::nan("");
    if (d > largest) largest = d;
  }
  return static_cast<double>(largest);
}
/// The largest entry of |a - b|. Evaluates both first: more template instances are expensive to compile.
template <class A, class B>
double distance(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  const Eigen::Matrix<typename A::Scalar, A::RowsAtCompileTime, A::ColsAtCompileTime> value = a, other = b;
  return distance(value.data(), other.data(), value.size());
}

/// `multiple` times the unit roundoff of S, as a double.
template <class S>
double roundings(double multiple) {
  return multiple * static_cast<double>(unit_roundoff<S>());
}

}  // namespace trivium::test
