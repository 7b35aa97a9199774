#pragma once
/// A scene solved as printed in one formulation. Support for tests.

#include "formulations/side_by_side.hpp"
#include "formulations/testing/moving_body.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium::test {

template <class F>
struct Solved {
  using S = typename F::Scalar;

  Mechanism<S> mechanism;
  MechanismState<S> state;
  RowAnalysis rows;
  AugmentedSolver<F> solver;
  VectorX<S> x;  ///< full solution, lambda of minimum norm
  Unknowns<F> u;

  explicit Solved(const scenes::Scene& scene)
      : mechanism(make_mechanism<S>(scene)),
        state(make_state<S>(scene)),
        rows(analyse_rows(make_model<double>(scene))),
        solver(mechanism, state, rows),
        x(solver.solve()),
        u(solver.split(x)) {}
};

}  // namespace trivium::test
