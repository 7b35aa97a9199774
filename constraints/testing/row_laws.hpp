#pragma once
/// The laws of a constraint row, the same for whatever coordinates the bodies move in. A support of the
/// tests.

#include <array>

#include "bodies/testing/random.hpp"
#include "bodies/testing/taylor.hpp"
#include "constraints/basic_constraint.hpp"
#include "constraints/constraint_row.hpp"

namespace trivium::test {

/// A body on a smooth path: its kinematics now, the same along the path as a Taylor expansion, and the first
/// and second derivative of its unknowns.
template <BodyKinematics Body, BodyKinematics BodyAlong>
struct MovingBody {
  using S = typename Body::Scalar;
  using Motion = BodyAcceleration<S, Body::rotational_unknowns>;
  Body now;
  BodyAlong along;
  Motion velocity, acceleration;
};

inline constexpr int basic_kinds = 5;
inline const char* basic_kind_name(int kind) {
  constexpr std::array<const char*, basic_kinds> names{"DP1", "TurningDP1", "DP2", "D", "CD"};
  return names[kind];
}

/// A basic constraint with every number drawn, f(t) and alpha(t) among them; the same one in every Scalar.
template <class S>
BasicConstraint<S> sample_constraint(int kind, std::uint64_t seed) {
  Random random(seed);
  const Vector3<S> a = random.vector<S, 3>(), b = random.vector<S, 3>(), c = random.vector<S, 3>();
  const TimeFunction f = TimeFunction::Sum{
      {TimeFunction::Harmonic{random.uniform(), random.uniform(), random.uniform(1, 2), random.uniform()},
       TimeFunction::Polynomial{{random.uniform(), random.uniform(), random.uniform()}}}};
  const BodyPair bodies{0, 1};
  switch (kind) {
    case 0:
      return DP1<S>{bodies, a, b, f};
    case 1:
      return TurningDP1<S>{bodies, a, b, c, f};
    case 2:
      return DP2<S>{bodies, a, b, c, f};
    case 3:
      return D<S>{bodies, a, b, f};
    default:
      return CD<S>{bodies, a, b, c, f};
  }
}

/// Phi_q q' of a row for given derivatives of its bodies' unknowns.
template <class S, int N>
S row_times(const ConstraintRow<S, N>& row, const BodyAcceleration<S, N>& on_i,
            const BodyAcceleration<S, N>& on_j) {
  return row.r_i.dot(on_i.r_ddot) + row.rot_i.dot(on_i.q_ddot) + row.r_j.dot(on_j.r_ddot) +
         row.rot_j.dot(on_j.q_ddot);
}

/// The largest violations over the cases seen.
struct RowErrors {
  double value = 0, velocity = 0, acceleration = 0, row_acceleration = 0;
};

/// Phi' = Phi_q q' - nu and Phi'' = Phi_q q'' - gamma along the path, and row_acceleration is Phi''.
template <class Moving, class S>
void measure_row(int kind, std::uint64_t seed, const Moving& i, const Moving& j, const Taylor<S>& t,
                 RowErrors& worst) {
  const auto constraint = sample_constraint<S>(kind, seed);
  const Taylor<S> phi = evaluate_row(sample_constraint<Taylor<S>>(kind, seed), i.along, j.along, t).phi;
  const auto row = evaluate_row(constraint, i.now, j.now, t.d0);
  const auto raise = [](double& error, const S& difference) {
    const double size = std::abs(static_cast<double>(difference));
    if (!(size <= error)) error = size;
  };
  raise(worst.value, row.phi - phi.d0);
  // a frozen t (d1 = 0) leaves the Jacobian alone
  raise(worst.velocity, row_times(row, i.velocity, j.velocity) - t.d1 * row.nu - phi.d1);
  if (t.d1 == S(0)) return;
  raise(worst.acceleration, row_times(row, i.acceleration, j.acceleration) - row.gamma - phi.d2);
  raise(worst.row_acceleration,
        row_acceleration(constraint, i.now, j.now, t.d0, i.acceleration, j.acceleration) - phi.d2);
}

}  // namespace trivium::test
