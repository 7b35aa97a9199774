#pragma once
/// A scene solved in one formulation, and the typed suite of all of them. A support of the tests.

#include "formulations/moving_body.hpp"
#include "formulations/side_by_side.hpp"

namespace trivium::test {

template <class F>
struct Solved {
  using S = typename F::Scalar;

  Mechanism<S> mechanism;
  MechanismState<S> state;
  RowAnalysis rows;
  AugmentedSolver<F> solver;
  VectorX<S> x;  ///< all unknowns, lambda of minimum norm
  Unknowns<F> u;

  explicit Solved(const scenes::Scene& scene)
      : mechanism(make_mechanism<S>(scene)),
        state(make_state<S>(scene)),
        rows(analyse_rows(scene, 0)),
        solver(mechanism, state, rows),
        x(solver.solve()),
        u(solver.split(x)) {}
};

}  // namespace trivium::test
