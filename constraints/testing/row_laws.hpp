#pragma once
/// The laws that relate Phi, nu, gamma and the Jacobian of a constraint row, in the coordinates of any
/// formulation. Used by tests only: Phi over Taylor numbers gives Phi' and Phi'' independently.

#include <array>
#include <type_traits>
#include <variant>

#include "base/raise.hpp"
#include "base/variants.hpp"
#include "bodies/testing/random.hpp"
#include "bodies/testing/taylor.hpp"
#include "constraints/basic_constraint.hpp"
#include "constraints/constraint_row.hpp"

namespace trivium::test {

/// A body on a smooth path at one instant.
template <BodyKinematics Body, BodyKinematics BodyAlong>
struct MovingBody {
  using S = typename Body::Scalar;
  using Motion = BodyAcceleration<S, Body::rotational_unknowns>;
  Body now;                       ///< kinematics at the instant
  BodyAlong along;                ///< kinematics over Taylor, differentiated along the path
  Motion velocity, acceleration;  ///< first and second derivatives of the coordinates
};

inline constexpr int basic_kinds = std::variant_size_v<BasicConstraint<double>>;
inline const char* basic_kind_name(int kind) {
  const auto name_of = []<class One>(const One&) {
    if constexpr (requires { One::type; })
      return One::type;
    else
      return "one that scene files do not name";
  };
  return std::visit(name_of, emplaced<BasicConstraint<double>>(kind));
}

inline TimeFunction sample_function(Random& random) {
  // drawn one after the other, since C++ does not fix the order in which arguments are evaluated
  std::array<double, 7> x;
  for (double& drawn : x) drawn = random.uniform();
  return TimeFunction::Sum{{TimeFunction::Harmonic{x[0], x[1], 1.5 + x[2] / 2, x[3]},
                            TimeFunction::Polynomial{{x[4], x[5], x[6]}}}};
}

/// A basic constraint with random vectors, points and functions of time; the same for a seed in every Scalar.
template <class S>
BasicConstraint<S> sample_constraint(int kind, std::uint64_t seed) {
  Random random(seed);
  auto sample = emplaced<BasicConstraint<S>>(kind);
  const auto draw = [&]<class Part>(Part& part) {
    if constexpr (std::is_same_v<Part, Vector3<S>>)
      part = random.vector<S, 3>();
    else if constexpr (std::is_same_v<Part, TimeFunction>)
      part = sample_function(random);
  };
  std::visit(
      [&](auto& row) {
        show_constraint_parts(draw, row);
        row.i = 0;
        row.j = 1;
      },
      sample);
  return sample;
}

/// Phi_q q' (or Phi_q q'') of a row for given first (second) derivatives of the coordinates of its bodies.
template <class S, int N>
S row_times(const ConstraintRow<S, N>& row, const BodyAcceleration<S, N>& on_i,
            const BodyAcceleration<S, N>& on_j) {
  return row.r_i.dot(on_i.r_ddot) + row.rot_i.dot(on_i.q_ddot) + row.r_j.dot(on_j.r_ddot) +
         row.rot_j.dot(on_j.q_ddot);
}

/// The largest errors of the laws over all cases.
struct RowErrors {
  double value = 0, velocity = 0, acceleration = 0, row_acceleration = 0;
};

/// Updates `worst` with the errors of Phi' = Phi_q q' - nu, Phi'' = Phi_q q'' - gamma and row_acceleration.
template <class Moving, class S>
void measure_row(int kind, std::uint64_t seed, const Moving& i, const Moving& j, const Taylor<S>& t,
                 RowErrors& worst) {
  const auto constraint = sample_constraint<S>(kind, seed);
  const Taylor<S> phi = evaluate_row(sample_constraint<Taylor<S>>(kind, seed), i.along, j.along, t).phi;
  const auto row = evaluate_row(constraint, i.now, j.now, t.d0);
  const auto raise = [](double& error, const S& difference) {
    trivium::raise(error, std::abs(static_cast<double>(difference)));
  };
  raise(worst.value, row.phi - phi.d0);
  // with t constant along the path (d1 = 0), this tests the Jacobian alone
  raise(worst.velocity, row_times(row, i.velocity, j.velocity) - t.d1 * row.nu - phi.d1);
  if (t.d1 == S(0)) return;
  raise(worst.acceleration, row_times(row, i.acceleration, j.acceleration) - row.gamma - phi.d2);
  raise(worst.row_acceleration,
        row_acceleration(constraint, i.now, j.now, t.d0, i.acceleration, j.acceleration) - phi.d2);
}

}  // namespace trivium::test
