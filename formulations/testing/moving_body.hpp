#pragma once
/// Bodies on smooth paths in the coordinates of each formulation, as second-order Taylor expansions, for
/// laws that hold along any path. Support for tests.

#include <algorithm>
#include <string>
#include <tuple>

#include "bodies/numbers/quad.hpp"
#include "bodies/rotations/so3.hpp"
#include "constraints/testing/row_laws.hpp"
#include "formulations/formulation_list.hpp"

namespace trivium::test {

template <class F>
using AlongT = InScalarT<F, Taylor<typename F::Scalar>>;

template <class F>
using MovingIn = MovingBody<typename F::Kinematics, typename AlongT<F>::Kinematics>;

inline NoChart chart_along(const NoChart&) { return {}; }
template <class S>
EulerChart<Taylor<S>> chart_along(const EulerChart<S>& chart) {
  return {chart.sequence, chart.reframing, constant<S, 3, 3>(chart.C)};
}

/// A pose and the first and second derivatives of the coordinates; q' and q'' are drawn independently.
template <class F>
struct Path {
  using S = typename F::Scalar;
  typename F::Chart chart;
  Vector4<S> p;
  Vector3<S> r, r_dot, r_ddot;
  typename F::Unknown q_dot, q_ddot;
};

/// A(t) = A (I + W t + (W^2 + W') t^2 / 2): A' = A W.
template <class S>
std::pair<typename ROmega<S>::Coordinates, typename ROmega<Taylor<S>>::Coordinates> coordinates(
    const Path<ROmega<S>>& path) {
  const Matrix3<S> A = rotation_matrix(path.p), W = tilde(path.q_dot), W_dot = tilde(path.q_ddot);
  const Vector3<S> zero = Vector3<S>::Zero();
  return {{A, path.q_dot},
          {taylor<S, 3, 3>(A, A * W, A * (W * W + W_dot)), taylor<S, 3, 1>(path.q_dot, path.q_ddot, zero)}};
}
/// p' and p'' are arbitrary, so the path may leave the unit sphere.
template <class S>
std::pair<typename RP<S>::Coordinates, typename RP<Taylor<S>>::Coordinates> coordinates(
    const Path<RP<S>>& path) {
  const Vector4<S> zero = Vector4<S>::Zero();
  return {{path.p, path.q_dot},
          {taylor<S, 4, 1>(path.p, path.q_dot, path.q_ddot), taylor<S, 4, 1>(path.q_dot, path.q_ddot, zero)}};
}
template <class S, class AnyPath>
std::pair<typename REpsilon<S>::Coordinates, typename REpsilon<Taylor<S>>::Coordinates> angles(
    const AnyPath& path) {
  const Vector3<S> zero = Vector3<S>::Zero(),
                   epsilon = REpsilon<S>::from_pose(path.chart, path.p, zero).epsilon;
  return {
      {epsilon, path.q_dot},
      {taylor<S, 3, 1>(epsilon, path.q_dot, path.q_ddot), taylor<S, 3, 1>(path.q_dot, path.q_ddot, zero)}};
}
template <class S>
auto coordinates(const Path<REpsilon<S>>& path) {
  return angles<S>(path);
}
template <class S>
auto coordinates(const Path<REpsilonOmegaFirst<S>>& path) {
  return angles<S>(path);
}

template <class F>
MovingIn<F> moving_body(const Path<F>& path) {
  using S = typename F::Scalar;
  using Along = AlongT<F>;
  const auto [now, along] = coordinates(path);
  const Vector3<S> zero = Vector3<S>::Zero();
  const typename Along::Kinematics moving =
      Along::kinematics(chart_along(path.chart), taylor<S, 3, 1>(path.r, path.r_dot, path.r_ddot),
                        taylor<S, 3, 1>(path.r_dot, path.r_ddot, zero), along);
  MovingIn<F> body{F::kinematics(path.chart, path.r, path.r_dot, now),
                   moving,
                   {path.r_dot, path.q_dot},
                   {path.r_ddot, path.q_ddot}};
  // r-epsilon-omega-first moves along a path of angles, but its velocity is omega_bar
  if constexpr (std::same_as<F, REpsilonOmegaFirst<S>>) {
    body.velocity.q_ddot = body.now.omega_bar;
    body.acceleration.q_ddot = first_derivative<S, 3, 1>(moving.omega_bar);
  }
  return body;
}

template <class F>
Path<F> random_path(Random& random, const ChartOptions& options) {
  using S = typename F::Scalar;
  constexpr int n = F::rotational_unknowns;
  Path<F> path;
  path.p = random.euler_parameters<S>();
  path.chart = F::choose_chart(options, path.p);
  path.r = random.vector<S, 3>();
  path.r_dot = random.vector<S, 3>();
  path.r_ddot = random.vector<S, 3>();
  path.q_dot = random.vector<S, n>();
  path.q_ddot = random.vector<S, n>();
  return path;
}

/// All sequences, with and without re-framing; formulations without charts get the same number of cases.
template <class Use>
void for_all_charts(const Use& use) {
  for (const auto name : euler_sequence_names)
    for (const bool reframe : {true, false}) use(ChartOptions{*parse_euler_sequence(name), reframe});
}

template <class... Tuples>
struct TypesOf;
template <class... F, class... G>
struct TypesOf<std::tuple<F...>, std::tuple<G...>> {
  using Types = testing::Types<F..., G...>;
};
/// GoogleTest type list of the library's formulations.
template <class S>
using AllFormulations = typename TypesOf<trivium::AllFormulations::In<S>, std::tuple<>>::Types;
using TestedFormulations =
    TypesOf<trivium::AllFormulations::In<double>, trivium::AllFormulations::In<Quad>>::Types;
/// Test names with underscores: hyphens have a meaning in GoogleTest filters.
struct FormulationNames {
  template <class F>
  static std::string GetName(int) {
    std::string name(F::name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name + (std::same_as<typename F::Scalar, double> ? "_double" : "_quad");
  }
};

}  // namespace trivium::test
