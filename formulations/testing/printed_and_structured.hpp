#pragma once
/// A scene solved by the structured and by the printed solver. Support for tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/raise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/side_by_side.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "formulations/testing/moving_body.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium::test {

/// The solution of a structured solver, converted to the scalar type To.
template <class To, class F>
PhysicalSolution<To> solution_of(const Mechanism<typename F::Scalar>& mechanism,
                                 const AccelerationSolver<F>& solver) {
  PhysicalSolution<To> solution;
  for (int b = 0; b < mechanism.nb(); ++b) {
    solution.r_ddot.push_back(scalar_cast<To>(solver.r_ddot(b)));
    solution.omega_bar_dot.push_back(scalar_cast<To>(solver.omega_bar_dot(b)));
  }
  solution.lambda = scalar_cast<To>(solver.lambda());
  return solution;
}

template <class F>
struct SolvedTwice {
  using S = typename F::Scalar;

  Mechanism<S> mechanism;
  MechanismState<S> state;
  SideBySide<S> printed;
  std::vector<BodyState<F>> bodies;
  AccelerationSolver<F> structured;
  PhysicalSolution<S> by_print, by_graph;

  explicit SolvedTwice(const scenes::Scene& scene)
      : mechanism(make_mechanism<S>(scene)),
        state(make_state<S>(scene)),
        printed(test::solve_scene<S>(scene, {{std::string(F::name)}, {}}, false)),
        bodies(to_coordinates<F>(mechanism, state, {})),
        structured(mechanism),
        by_print(printed.formulations.front().solution) {
    structured.solve(bodies, state.t);
    by_graph = solution_of<S>(mechanism, structured);
  }

  double accelerations_apart() const { return acceleration_distance(printed.rows, by_graph, by_print).all; }
  double lambda_apart() const { return lambda_distance(printed.rows, by_graph.lambda, by_print.lambda); }
  /// Difference of Phi_q^T lambda on a body, relative to the largest force of a row [-].
  double forces_apart() const {
    const auto eom =
        equations_of_motion<ROmega<S>>(mechanism, to_coordinates<ROmega<S>>(mechanism, state, {}), state.t);
    double largest = 0, apart = 0;
    std::vector<Vector<S, 6>> difference(eom.nb() + 1, Vector<S, 6>::Zero());
    for (int k = 0; k < eom.nc(); ++k) {
      const S excess = by_graph.lambda[k] - by_print.lambda[k];
      const auto add = [&](int body, const auto& r, const auto& rot) {
        Vector<S, 6> gradient;
        gradient << r.transpose(), rot.transpose();
        difference[body] += excess * gradient;
        raise(largest, static_cast<double>(S((by_print.lambda[k] * gradient).norm())));
      };
      add(eom.pair[k].i, eom.row[k].r_i, eom.row[k].rot_i);
      add(eom.pair[k].j, eom.row[k].r_j, eom.row[k].rot_j);
    }
    for (int b = 0; b < eom.nb(); ++b) raise(apart, static_cast<double>(S(difference[b].norm())));
    return largest > 0 ? apart / largest : apart;
  }
};

/// Expects equal rank and unique multipliers, and equal accelerations, unique lambda and Phi_q^T lambda to
/// rounding.
template <class F>
void expect_agreement(const scenes::Scene& scene, const std::string& what) {
  SolvedTwice<F> s(scene);
  ASSERT_EQ(s.printed.formulations.front().error, "") << what;
  const double bound = s.printed.lambda_bound();
  EXPECT_EQ(s.structured.rank(), s.printed.rows.rank) << what;
  EXPECT_EQ(s.structured.unique(), s.printed.rows.unique) << what;
  EXPECT_LE(s.accelerations_apart(), bound) << what;
  EXPECT_LE(s.lambda_apart(), bound) << what;
  // redundant rows are dependent only to the rounding of the scene's numbers, which are doubles: hence 1e-14
  const bool redundant = s.printed.rows.rank < s.mechanism.nc();
  EXPECT_LE(s.forces_apart(), std::max(10 * bound, redundant ? 1e-14 : 0.0)) << what;
}

/// Random scenes with 1 to 6 bodies: trees and loops, some with redundant rows or drivers.
inline scenes::Scene varied_scene(std::uint64_t seed) {
  MechanismOptions o;
  o.bodies = 1 + static_cast<int>(seed % 6);
  o.closings = static_cast<int>(seed / 2 % 3);
  o.doubled = static_cast<int>(seed / 5 % 3);
  o.driven = o.doubled == 0 && seed % 2 == 0;
  o.mass_decades = seed % 7 == 0 ? 3 : 0.5;
  return random_scene(seed, o);
}

template <class F>
void expect_agreement_on(std::uint64_t seeds) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed)
    expect_agreement<F>(varied_scene(seed), std::string(F::name) + " seed " + std::to_string(seed));
}

}  // namespace trivium::test
